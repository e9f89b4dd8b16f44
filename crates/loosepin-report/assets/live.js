"use strict";
// Stands in the head of the page: only where scripts run are there buttons, sliders and read-outs.
document.documentElement.classList.add('live');
