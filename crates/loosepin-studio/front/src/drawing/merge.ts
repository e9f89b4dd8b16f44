// Brings a picture that is shown up to a new one without taking its elements away: the focus stays, and little is laid out anew.

/** What may be taken over of nodes that come from elsewhere. */
export interface Filter {
  isAllowed(element: Element): boolean;
  attributesOf(element: Element): [name: string, value: string][];
  textOf(node: Node): string;
}

/** For nodes of the page itself. */
const unfiltered: Filter = {
  isAllowed: () => true,
  attributesOf: (element) => [...element.attributes].map(({ name, value }) => [name, value]),
  textOf: (node) => node.nodeValue ?? '',
};

/** Layers whose contents are drawn by others. */
const foreignLayers = new Set(['traces', 'zones-now', 'labels']);
/** Set by what moves the picture. */
const moved = 'transform';

function mergeAttributes(shown: SVGElement, attributes: [string, string][]): void {
  for (const [name, value] of attributes) {
    if (shown.getAttribute(name) === value) continue;
    // The policy of the page forbids `style` to be set as text.
    if (name === 'style') shown.style.cssText = value;
    else shown.setAttribute(name, value);
  }
  if (shown.attributes.length === attributes.length) return;
  const names = new Set(attributes.map(([name]) => name));
  for (const { name } of [...shown.attributes]) {
    if (!names.has(name) && name !== moved) shown.removeAttribute(name);
  }
}

/** Makes `shown` like `found`, where both have the same elements in the same order; else false, and it is to be replaced. */
function mergeInto(shown: Node | undefined, found: Node, filter: Filter): boolean {
  if (shown?.nodeType !== found.nodeType) return false;
  if (found.nodeType === Node.TEXT_NODE) {
    const text = filter.textOf(found);
    if (shown.nodeValue !== text) shown.nodeValue = text;
    return true;
  }
  if (!(shown instanceof SVGElement) || !(found instanceof Element)) return false;
  if (shown.localName !== found.localName || !filter.isAllowed(found)) return false;
  mergeAttributes(shown, filter.attributesOf(found));
  if (foreignLayers.has(found.getAttribute('class') ?? '')) return true;
  const [before, after] = [shown.childNodes, found.childNodes];
  return before.length === after.length && [...after].every((node, index) => mergeInto(before[index], node, filter));
}

/**
 * Makes a picture that is shown like a parsed one, with `layers` before and behind it; at its end it may have more. Where it is made otherwise,
 * false: it is to be replaced.
 */
export function mergePicture(shown: SVGSVGElement, found: SVGSVGElement, filter: Filter, layers: { under: SVGElement[]; over: SVGElement[] }): boolean {
  const parts: [Node, Filter][] = [
    ...layers.under.map((layer): [Node, Filter] => [layer, unfiltered]),
    ...[...found.childNodes].map((node): [Node, Filter] => [node, filter]),
    ...layers.over.map((layer): [Node, Filter] => [layer, unfiltered]),
  ];
  return parts.every(([node, by], index) => mergeInto(shown.childNodes[index], node, by));
}
