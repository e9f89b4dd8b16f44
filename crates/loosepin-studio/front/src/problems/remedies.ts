// The tools that mend what a mechanism lacks, by the code of the problem.
import type { EditTool } from '../editing/toolset.ts';

const remedies: Record<string, readonly EditTool[]> = {
  /** Fewer drives than degrees of freedom. */
  E0701: ['join', 'link', 'motor'],
  /** More drives than degrees of freedom. */
  E0702: ['delete'],
};

export function remediesOf(code: string): readonly EditTool[] {
  return remedies[code] ?? [];
}

/** Whether a view that does not move yet says the same, in fewer words. */
export function isMobility(code: string): boolean {
  return code in remedies;
}
