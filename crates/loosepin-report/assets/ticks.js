"use strict";
// Ticks of axes and numbers in words. `ticks` and `tickText` follow the rules of src/ticks.rs; a test holds both to the same texts.
const ANGLE_STEPS = [0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720];
const LEAST_OF_ANGLES = 0.2;
function ticks(from, to, least, areAngles) {
    if (!(isFinite(from) && isFinite(to) && to > from && least > 0))
        return { values: [], step: 1 };
    const power = 10 ** Math.floor(Math.log10(least));
    const plain = [1, 2, 5, 10].map((multiple) => multiple * power).find((step) => step >= least) ?? least;
    const step = (areAngles && least > LEAST_OF_ANGLES ? ANGLE_STEPS.find((angle) => angle >= least) : undefined) ?? plain;
    const slack = 1e-9;
    const [first, last] = [Math.ceil(from / step - slack), Math.floor(to / step + slack)];
    if (last <= first)
        return ticks(from, to, 0.5 * least, areAngles);
    const values = [];
    for (let k = first; k <= last; k += 1)
        values.push(k * step);
    return { values, step };
}
function superscript(exponent) {
    return String(exponent).replace(/[-0-9]/g, (c) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)] ?? c);
}
function grouped(text) {
    const [whole = '', rest] = text.replace('-', '−').split('.');
    const apart = whole.replace('−', '').length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
    return rest === undefined ? apart : apart + '.' + rest;
}
function tickText(value, step) {
    if (value === 0)
        return '0';
    const magnitude = Math.abs(value);
    if (magnitude >= 1e7 || step < 1e-4) {
        const exponent = Math.floor(Math.log10(magnitude));
        const places = Math.max(0, exponent - Math.floor(Math.log10(step)));
        return (value / 10 ** exponent).toFixed(places).replace('-', '−') + '·10' + superscript(exponent);
    }
    let places = 0;
    while (places < 10 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6)
        places += 1;
    return grouped(value.toFixed(places));
}
/** A number that is read off: to the places of `step`, or in four digits. */
function readText(value, step) {
    if (!isFinite(value))
        return '–';
    const magnitude = Math.abs(value);
    if (magnitude !== 0 && (magnitude < 1e-4 || magnitude >= 1e7)) {
        const [mantissa, exponent] = value.toExponential(2).split('e');
        return String(mantissa).replace('-', '−') + '·10' + superscript(Number(exponent));
    }
    let places = magnitude === 0 ? 0 : Math.max(0, 3 - Math.floor(Math.log10(magnitude)));
    if (step !== undefined) {
        places = 0;
        while (places < 10 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6)
            places += 1;
    }
    return grouped(value.toFixed(Math.min(places, 10)));
}
function withUnit(words, symbol) {
    if (symbol === '')
        return words;
    return symbol === '°' || symbol === '%' ? words + symbol : words + ' ' + symbol;
}
