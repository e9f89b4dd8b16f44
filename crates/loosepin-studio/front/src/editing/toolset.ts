// The tools of both drawings: of a new mechanism, and of one that is there already.

export const tools = ['link', 'plate', 'ground', 'slider', 'motor', 'delete'] as const;
export type Tool = (typeof tools)[number];

export const editTools = ['move', 'link', 'plate', 'join', 'slider', 'ground', 'motor', 'delete'] as const;
export type EditTool = (typeof editTools)[number];
