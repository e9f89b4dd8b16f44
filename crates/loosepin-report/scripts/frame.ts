// Links a figure in a frame of a notebook with the widget around it (`widget.ts`): angle of the cursor, colours, height.
(() => {
  type FrameMessage = import('./frame-messages.d.ts').FrameMessage;
  type WidgetMessage = import('./frame-messages.d.ts').WidgetMessage;
  /** Least time between two angles of a mechanism that plays. */
  const everyMs = 100;

  const main = document.querySelector('main');
  const turnsBeforeDeg = Number(main?.dataset.turnsBefore ?? 0);
  const poses = document.querySelector('[data-mechanism] script[type="application/json"]')?.textContent;
  const motion = poses ? JSON.parse(poses) as { angle_deg: number[]; start: number } : null;
  const firstDeg = motion?.angle_deg[motion.start] ?? null;
  // The colours follow the notebook, not the system.
  const darkRules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule): rule is CSSMediaRule => rule instanceof CSSMediaRule && rule.media.mediaText.includes('prefers-color-scheme'));

  // Any window may show the figure: what it says about itself is no secret.
  const send = (message: FrameMessage): void => parent.postMessage(message, '*');

  const sendHeight = (): void => send({ kind: 'loosepin-height', heightPx: Math.ceil(document.body.getBoundingClientRect().height) });

  function setColours(isDark: boolean): void {
    // Paper is light.
    darkRules.forEach((rule) => { rule.media.mediaText = isDark ? 'screen' : 'not all'; });
    document.documentElement.style.colorScheme = isDark ? 'dark' : 'light';
  }

  let pending: number | null = null;
  let timer = 0;
  function sendPending(): void {
    timer = 0;
    if (pending !== null) send({ kind: 'loosepin-angle', angleDeg: pending });
    pending = null;
  }

  const fromWidget = {};
  pageCursor.listen((angleDeg, from, reason) => {
    if (from === fromWidget || reason === 'opened') return;
    pending = turnsBeforeDeg + angleDeg;
    if (reason === 'played' && timer === 0) timer = window.setTimeout(sendPending, everyMs);
    if (reason === 'chosen') {
      clearTimeout(timer);
      sendPending();
    }
  });
  // The angle that the charts and the mechanism begin with: a notebook has no address for it, and nothing plays before it is asked to.
  pageCursor.inAddress = () => firstDeg;

  addEventListener('message', (event: MessageEvent<WidgetMessage | null>) => {
    if (event.source !== parent) return;
    if (event.data?.kind === 'loosepin-colours') setColours(event.data.isDark);
    if (event.data?.kind === 'loosepin-angle') pageCursor.set(event.data.angleDeg - turnsBeforeDeg, fromWidget, 'opened');
  });
  addEventListener('load', () => {
    // An observer sleeps while the frame is out of sight.
    sendHeight();
    new ResizeObserver(sendHeight).observe(document.body);
    send({ kind: 'loosepin-ready' });
  });
})();
