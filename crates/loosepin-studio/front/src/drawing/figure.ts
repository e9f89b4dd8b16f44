// Makes nodes of the SVG texts of the server, copied one by one by the list of what is allowed.
import { isAllowedAttribute, isAllowedElement } from './allowed.ts';
import type { Filter } from './merge.ts';

const namespace = 'http://www.w3.org/2000/svg';
// The policy of the page forbids `style` attributes in what is parsed, and would report each. So they are parsed under another name.
const [asWritten, asParsed] = [' style="', ' data-inline-style="'];

interface Policy {
  createHTML(text: string): string;
}

interface PolicyFactory {
  createPolicy(name: string, rules: { createHTML: (text: string) => string }): Policy;
}

// The only place where a text is parsed. What comes of it is a document of its own, where no script runs, and is then filtered.
const policy: Policy = ((): Policy => {
  const factory = (globalThis as { trustedTypes?: PolicyFactory }).trustedTypes;
  const rules = { createHTML: (text: string) => text };
  return factory ? factory.createPolicy('loosepin-figure', rules) : rules;
})();

const parsedStyle = asParsed.trim().slice(0, -2);

/** What may be taken over of a parsed text. */
export const filtered: Filter = {
  isAllowed: (element) => element.namespaceURI === namespace && isAllowedElement(element.localName),
  written: (attribute) => {
    const name = attribute.name === parsedStyle ? 'style' : attribute.name === 'xlink:href' ? 'href' : attribute.name;
    return [name, attribute.value.includes(parsedStyle) ? attribute.value.replaceAll(asParsed, asWritten) : attribute.value];
  },
  isAllowedAttribute,
  textOf: (node) => (node.nodeValue ?? '').replaceAll(asParsed, asWritten),
};

/** Nodes of the page for a parsed picture. */
export function copied(element: Element): SVGElement | null {
  if (!filtered.isAllowed(element)) return null;
  const copy = document.createElementNS(namespace, element.localName);
  for (const attribute of element.attributes) {
    const [name, value] = filtered.written(attribute);
    if (!isAllowedAttribute(element.localName, name, value)) continue;
    if (name === 'style') copy.style.cssText = value;
    else copy.setAttribute(name, value);
  }
  for (const child of element.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) copy.append(filtered.textOf(child));
    else if (child.nodeType === Node.ELEMENT_NODE) {
      const inner = copied(child as Element);
      if (inner) copy.append(inner);
    }
  }
  return copy;
}

/** A drawing, parsed and not yet filtered: nothing of it may be put into the page but by [`copied`] and [`mergePicture`]. */
export function parsedFigure(svg: string): SVGSVGElement | null {
  // Saved pictures name their namespace, pictures of pages need not.
  const named = /^\s*<svg[^>]*\sxmlns=/.test(svg) ? svg : svg.replace('<svg', `<svg xmlns="${namespace}"`);
  const parsed = new DOMParser().parseFromString(policy.createHTML(named.replaceAll(asWritten, asParsed)), 'image/svg+xml');
  const root = parsed.documentElement;
  if (root.localName !== 'svg' || parsed.getElementsByTagName('parsererror').length > 0) return null;
  return root as Element as SVGSVGElement;
}

/** The drawing as nodes, or null where the text is none. */
export function figureOf(svg: string): SVGSVGElement | null {
  const parsed = parsedFigure(svg);
  return parsed && (copied(parsed) as SVGSVGElement | null);
}
