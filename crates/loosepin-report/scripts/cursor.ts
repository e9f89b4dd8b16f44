// The one cursor of the page: the angle of the drive that mechanism and charts show, kept in the address as #a=93.

/** Why the angle is another one: a person chose it, the mechanism plays, or it stood in the address. */
type CursorReason = 'chosen' | 'played' | 'opened';
type CursorListener = (angleDeg: number, from: unknown, reason: CursorReason) => void;

const pageCursor = (() => {
  const listeners: CursorListener[] = [];
  let timer = 0;
  return {
    listen(hear: CursorListener): void {
      listeners.push(hear);
    },
    /** Moves all figures but `from`; the address follows where a person chose the angle. */
    set(angleDeg: number, from: unknown, reason: CursorReason): void {
      listeners.forEach((hear) => hear(angleDeg, from, reason));
      if (reason !== 'chosen') return;
      clearTimeout(timer);
      timer = window.setTimeout(() => {
        try {
          history.replaceState(null, '', '#a=' + Number(angleDeg.toFixed(1)));
        } catch {
          // Some viewers of mail allow no address.
        }
      }, 150);
    },
    /** The angle in the address, or nothing. */
    inAddress(): number | null {
      const found = /^#a=(-?\d+(?:\.\d+)?)$/.exec(location.hash);
      return found ? Number(found[1]) : null;
    },
  };
})();
