// Brings a picture that is shown up to a new one without taking its elements away: the focus stays, and little is laid out anew.

/** How nodes that come from elsewhere are written, and what may be taken over of them. */
export interface Filter {
  isAllowed(element: Element): boolean;
  written(attribute: Attr): [name: string, value: string];
  isAllowedAttribute(element: string, name: string, value: string): boolean;
  textOf(node: Node): string;
}

/** For nodes of the page itself. */
const unfiltered: Filter = {
  isAllowed: () => true,
  written: ({ name, value }) => [name, value],
  isAllowedAttribute: () => true,
  textOf: (node) => node.nodeValue ?? '',
};

/** Layers whose contents are drawn by others. */
const foreignLayers = new Set(['traces', 'zones-now', 'labels']);
/** Set by what moves the picture. */
const moved = 'transform';

function mergeAttributes(shown: SVGElement, found: Element, filter: Filter): void {
  const names = new Set<string>();
  for (const attribute of found.attributes) {
    const [name, value] = filter.written(attribute);
    names.add(name);
    // What is shown was allowed before.
    if (shown.getAttribute(name) === value) continue;
    if (!filter.isAllowedAttribute(found.localName, name, value)) names.delete(name);
    // The policy of the page forbids `style` to be set as text.
    else if (name === 'style') shown.style.cssText = value;
    else shown.setAttribute(name, value);
  }
  if (shown.attributes.length === names.size) return;
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
  mergeAttributes(shown, found, filter);
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
