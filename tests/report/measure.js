// Into a copy of a page: what does not fit, and text whose contrast is below 4.5 (WCAG 2.1), as text of the page.
'use strict';
function luminance(colour) {
    const c = colour.match(/[\d.]+/g).slice(0, 3).map(v => v / 255)
        .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}
function ground(element) {
    for (let e = element; e; e = e.parentElement) {
        if (e.namespaceURI.endsWith('svg')) continue;
        const colour = getComputedStyle(e).backgroundColor;
        if (!/, 0\)$/.test(colour)) return colour;
    }
    return 'rgb(255, 255, 255)';
}
window.addEventListener('load', () => {
    const said = [], width = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth > width) said.push(`page ${document.documentElement.scrollWidth} wide in ${width}`);
    let least = 21, texts = 0;
    for (const e of document.querySelectorAll('body *')) {
        if ([...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) && e.tagName.toLowerCase() !== 'script') {
            const svg = e.namespaceURI.endsWith('svg');
            const back = svg ? getComputedStyle(e.closest('svg')).backgroundColor : ground(e);
            const style = getComputedStyle(e), a = luminance(svg ? style.fill : style.color), b = luminance(back);
            const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            texts++;
            if (contrast < least) least = contrast;
            if (contrast < 4.5) said.push(`contrast ${contrast.toFixed(2)}: ${e.textContent.slice(0, 40)}`);
        }
        const box = e.getBoundingClientRect();
        if (box.right > width + 0.5 && !e.closest('.film') && !e.closest('svg')) said.push(`${e.tagName} reaches to ${box.right}: ${e.textContent.slice(0, 40)}`);
    }
    for (const i of document.images) if (!i.naturalWidth) said.push('a picture that is none');
    parent.document.getElementById('said').textContent = [`${texts} texts, ${width} wide, least contrast ${least.toFixed(2)}`, ...said].join('\n');
});
