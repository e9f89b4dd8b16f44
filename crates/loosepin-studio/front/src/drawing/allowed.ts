// What a drawing of the server may hold: nothing that runs, nothing that fetches.

const elements = new Set([
  'svg', 'g', 'path', 'line', 'rect', 'circle', 'ellipse', 'polyline', 'polygon', 'text', 'tspan', 'title', 'desc', 'defs', 'marker',
  'clipPath', 'use', 'pattern',
]);

const attributes = new Set([
  'class', 'id', 'role', 'style', 'viewBox', 'preserveAspectRatio', 'width', 'height', 'x', 'y', 'x1', 'y1', 'x2', 'y2', 'cx', 'cy', 'r', 'rx', 'ry',
  'dx', 'dy', 'd', 'points', 'transform', 'pathLength', 'rotate', 'textLength', 'lengthAdjust', 'fill', 'fill-opacity', 'fill-rule', 'stroke',
  'stroke-width', 'stroke-opacity', 'stroke-dasharray', 'stroke-dashoffset', 'stroke-linecap', 'stroke-linejoin', 'stroke-miterlimit', 'opacity',
  'vector-effect', 'paint-order', 'font-size', 'font-family', 'font-weight', 'font-style', 'text-anchor', 'dominant-baseline',
  'alignment-baseline', 'letter-spacing', 'clip-path', 'clip-rule', 'clipPathUnits', 'marker-start', 'marker-mid', 'marker-end', 'markerWidth',
  'markerHeight', 'markerUnits', 'refX', 'refY', 'orient', 'patternUnits', 'patternContentUnits', 'patternTransform', 'visibility', 'display',
]);

export function isAllowedElement(name: string): boolean {
  return elements.has(name);
}

/** Each `url(…)` names a part of the same drawing. */
function isLocal(value: string): boolean {
  return [...value.matchAll(/url\s*\(([^)]*)\)?/gi)].every((found) => /^\s*["']?#/.test(found[1] ?? ''));
}

export function isAllowedAttribute(element: string, name: string, value: string): boolean {
  if (name === 'href' || name === 'xlink:href') return element === 'use' && value.trim().startsWith('#');
  if (!attributes.has(name) && !/^(data|aria)-[a-z0-9-]+$/.test(name)) return false;
  // A backslash can hide `url` from the test above it.
  return isLocal(value) && !(name === 'style' && /[\\@]|image-set|import/i.test(value));
}
