// The tools of the canvas.

export const editTools = ['move', 'link', 'plate', 'join', 'slider', 'ground', 'motor', 'record', 'delete'] as const;
export type EditTool = (typeof editTools)[number];

/** How two points are joined. */
export const joinKinds = ['pin', 'slider', 'slot', 'rigid'] as const;
export type JoinKind = (typeof joinKinds)[number];

/** What an output records. */
export const recordKinds = ['path', 'x', 'y', 'angle', 'angular_velocity', 'force'] as const;
export type RecordKind = (typeof recordKinds)[number];

/** What is set of a tool before it is used. */
export interface ToolOptions {
  join: JoinKind;
  /** Direction of a line, degrees. */
  angle: number;
  /** As people write it; ideal where nothing is written. */
  play: string;
  record: RecordKind;
}
