// Arrow keys among cards that stand in rows.

/** How many cards stand in a row now. */
function perRow(cards: HTMLElement[]): number {
  const top = cards[0]?.getBoundingClientRect().top;
  return Math.max(cards.filter((card) => card.getBoundingClientRect().top === top).length, 1);
}

/** Moves the focus among the cards; gives the place of the card that has it now, or nothing. */
export function stepTo(cards: HTMLElement[], event: KeyboardEvent): number | null {
  const at = cards.findIndex((card) => card === document.activeElement);
  const row = perRow(cards);
  const steps: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: row, ArrowUp: -row, Home: -at, End: cards.length - 1 - at };
  const by = steps[event.key];
  if (at < 0 || by === undefined) return null;
  event.preventDefault();
  const next = cards[at + by];
  if (!next) return null;
  next.focus();
  return at + by;
}
