"use strict";
// Saves figures: the picture as the library drew it (SVG), as pixels (PNG), and its numbers (CSV).
const savedFigures = (() => {
    const widthMm = 160;
    const pixelsPerMm = 12;
    function download(name, content) {
        const link = document.createElement('a');
        link.href = URL.createObjectURL(content);
        link.download = name;
        link.click();
        window.setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }
    const inXml = (markup) => markup.replace(/&nbsp;/g, '\u00a0');
    /** The document that `loosepin report --svg` writes, byte for byte. */
    function svgText(svg, drawn) {
        // The saved picture has a key below, which the page has as buttons.
        const [left = 0, top = 0, width = 1, shown = 1] = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
        const height = shown + Number(svg.dataset.below ?? 0);
        const view = [left, top, width, height].join(' ');
        const title = document.createElement('span');
        title.textContent = svg.getAttribute('aria-label');
        const style = document.getElementById('saved-style')?.textContent ?? '';
        return '<svg xmlns="http://www.w3.org/2000/svg" class="' + svg.getAttribute('class') + '" width="' + widthMm.toFixed(1) + 'mm" height="'
            + (widthMm * height / width).toFixed(1) + 'mm" viewBox="' + view + '" role="img"><title>' + inXml(title.innerHTML).replace(/"/g, '&quot;')
            + '</title><style>' + style + '</style>' + inXml(drawn) + '</svg>\n';
    }
    function png(text, name) {
        const picture = new Image();
        picture.addEventListener('load', () => {
            const canvas = document.createElement('canvas');
            canvas.width = Math.round(widthMm * pixelsPerMm);
            canvas.height = Math.round(canvas.width * picture.height / picture.width);
            const context = canvas.getContext('2d');
            if (!context)
                return;
            context.fillStyle = '#ffffff';
            context.fillRect(0, 0, canvas.width, canvas.height);
            context.drawImage(picture, 0, 0, canvas.width, canvas.height);
            canvas.toBlob((blob) => { if (blob)
                download(name + '.png', blob); });
        });
        picture.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
    }
    const texts = new Map();
    document.querySelectorAll('[data-figure]').forEach((figure) => {
        const name = figure.dataset.figure ?? '';
        const svg = figure.querySelector('svg.figure');
        if (!svg)
            return;
        const table = figure.querySelector('script[type="text/csv"]');
        const origin = '# figure ' + name + ' of ' + (document.documentElement.dataset.origin ?? '') + '\n';
        const kept = { svg: svgText(svg, svg.innerHTML), csv: table ? origin + (table.textContent ?? '') : null };
        texts.set(name, kept);
        const row = document.createElement('div');
        row.className = 'save';
        const button = (label, save) => {
            const element = document.createElement('button');
            element.type = 'button';
            element.textContent = label;
            element.setAttribute('aria-label', 'Save ' + name + ' as ' + label);
            element.addEventListener('click', save);
            row.append(element);
        };
        button('SVG', () => download(name + '.svg', new Blob([kept.svg], { type: 'image/svg+xml' })));
        button('PNG', () => png(kept.svg, name));
        if (kept.csv !== null)
            button('CSV', () => download(name + '.csv', new Blob([kept.csv ?? ''], { type: 'text/csv' })));
        figure.append(row);
    });
    // The files that the result was computed from.
    document.querySelectorAll('[data-input]').forEach((details) => {
        const text = details.querySelector('pre')?.textContent ?? '';
        const button = document.createElement('button');
        button.type = 'button';
        button.textContent = 'Save ' + (details.dataset.input ?? '');
        button.addEventListener('click', () => download(details.dataset.input ?? 'input.toml', new Blob([text], { type: 'text/plain' })));
        const row = document.createElement('div');
        row.className = 'save plain';
        row.append(button);
        details.after(row);
    });
    return texts;
})();
