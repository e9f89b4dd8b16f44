"use strict";
// The one cursor of the page: the angle of the drive that mechanism and charts show, kept in the address as #a=93.
const pageCursor = (() => {
    const listeners = [];
    let timer = 0;
    return {
        listen(hear) {
            listeners.push(hear);
        },
        /** Moves all figures but `from`; the address follows where a person chose the angle. */
        set(angleDeg, from, reason) {
            listeners.forEach((hear) => hear(angleDeg, from, reason));
            if (reason !== 'chosen')
                return;
            clearTimeout(timer);
            timer = window.setTimeout(() => {
                try {
                    history.replaceState(null, '', '#a=' + Number(angleDeg.toFixed(1)));
                }
                catch {
                    // Some viewers of mail allow no address.
                }
            }, 150);
        },
        /** The angle in the address, or nothing. */
        inAddress() {
            const found = /^#a=(-?\d+(?:\.\d+)?)$/.exec(location.hash);
            return found ? Number(found[1]) : null;
        },
    };
})();
