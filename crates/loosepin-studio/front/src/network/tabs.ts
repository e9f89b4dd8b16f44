// Tabs of one studio say to each other what they have saved: a file that another tab wrote is no surprise.

interface Saved {
  path: string;
  tag: string;
}

const mostKept = 200;
const channel = new BroadcastChannel('loosepin-saved');
const saved = new Set<string>();
const keyOf = ({ path, tag }: Saved): string => `${tag} ${path}`;

channel.onmessage = (event: MessageEvent<Saved>) => {
  saved.add(keyOf(event.data));
  if (saved.size > mostKept) saved.delete(saved.values().next().value ?? '');
};

export function tellSaved(path: string, tag: string): void {
  channel.postMessage({ path, tag } satisfies Saved);
}

/** Whether another tab has saved this text of the file. */
export function isOfAnotherTab(path: string, tag: string): boolean {
  return saved.has(keyOf({ path, tag }));
}
