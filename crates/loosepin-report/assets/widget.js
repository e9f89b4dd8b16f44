const trait = 'drive_angle_rad';
const radPerDeg = Math.PI / 180;
/** Whether letters around the figure are light: every notebook has its own way to say which theme it has. */
function isDark(element) {
    const [red = 0, green = 0, blue = 0] = (getComputedStyle(element).color.match(/[\d.]+/g) ?? []).map(Number);
    return 0.299 * red + 0.587 * green + 0.114 * blue > 128;
}
function render({ model, el }) {
    const frame = document.createElement('iframe');
    frame.title = String(model.get('_title'));
    frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
    // Seen as soon as it has the colours of the notebook.
    Object.assign(frame.style, { display: 'block', width: '100%', height: '30rem', border: '0', visibility: 'hidden' });
    // A change of the theme, however it is made, is a change of this colour: it ends a transition.
    el.style.transition = 'color 1ms';
    frame.srcdoc = String(model.get('_document'));
    const send = (message) => frame.contentWindow?.postMessage(message, '*');
    const sendColours = () => {
        // A frame of another scheme than its document would have an opaque ground.
        frame.style.colorScheme = isDark(el) ? 'dark' : 'light';
        send({ kind: 'loosepin-colours', isDark: isDark(el) });
    };
    let known = null;
    const sendAngle = () => {
        const angle = model.get(trait);
        if (angle === known || typeof angle !== 'number')
            return;
        known = angle;
        send({ kind: 'loosepin-angle', angleDeg: angle / radPerDeg });
    };
    const hear = (event) => {
        if (event.source !== frame.contentWindow)
            return;
        const message = event.data;
        if (message === null)
            return;
        // A notebook takes cells that are out of sight off the page: there they have no height.
        if (message.kind === 'loosepin-height' && message.heightPx > 0 && frame.clientWidth > 0)
            frame.style.height = message.heightPx + 'px';
        if (message.kind === 'loosepin-angle') {
            known = message.angleDeg * radPerDeg;
            model.set(trait, known);
            model.save_changes();
        }
        if (message.kind === 'loosepin-ready') {
            sendColours();
            // A frame that is moved in the page loads again.
            known = null;
            sendAngle();
            frame.style.visibility = 'visible';
        }
    };
    addEventListener('message', hear);
    el.addEventListener('transitionend', sendColours);
    model.on('change:' + trait, sendAngle);
    el.append(frame);
    return () => {
        removeEventListener('message', hear);
        el.removeEventListener('transitionend', sendColours);
        model.off('change:' + trait, sendAngle);
    };
}
export default { render };
