"use strict";

// A map with a path on it, to zoom and to pan. Inside of the SVG lengths are metres, from the map's upper left corner.

const HEAT_STEPS = 8;
const MOST_ZOOM = 400;
const CLICK_PX = 5;
const NEAR_PX = 24;

const MAP_MARKUP = `
<div class="map" tabindex="0" role="application"
     aria-label="Map with the path. Arrow keys move it, plus and minus zoom, 0 shows all.">
  <svg preserveAspectRatio="none" aria-hidden="true">
    <image class="picture" preserveAspectRatio="none"></image>
    <path class="reference"></path>
    <g class="heat"></g>
    <circle class="start" data-px="5"></circle>
    <circle class="end" data-px="5"></circle>
    <circle class="here" data-px="8" visibility="hidden"></circle>
  </svg>
  <output class="readout"></output>
  <div class="scale"><span></span></div>
  <div class="zoom">
    <button type="button" data-zoom="0.5" aria-label="Zoom in">+</button>
    <button type="button" data-zoom="2" aria-label="Zoom out">&minus;</button>
    <button type="button" data-zoom="0" aria-label="Show all">All</button>
  </div>
</div>`;

function elementOf(markup) {
    const template = document.createElement("template");
    template.innerHTML = markup.trim();
    return template.content.firstElementChild;
}

/** The longest of 1, 2, 5 times a power of ten that is at most `limit`. */
function roundLength(limit) {
    const power = 10 ** Math.floor(Math.log10(limit));
    return (limit >= 5 * power ? 5 : limit >= 2 * power ? 2 : 1) * power;
}

/** [least, largest] of the numbers among the values; [0, 1] where there is none. */
function rangeOf(values) {
    const numbers = values.filter(Number.isFinite);
    return numbers.length ? numbers.reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], [Infinity, -Infinity])
                          : [0, 1];
}

class MapView {
    /** onRow(row): the pointer is near that row's place. */
    constructor(data, onRow) {
        this.onRow = onRow;
        this.area = data.map;
        this.element = elementOf(MAP_MARKUP);
        this.svg = this.element.querySelector("svg");
        this.x = data.place.x_m.map(x => x - this.area.left_m);
        this.y = data.place.y_m.map(y => this.area.bottom_m + this.area.height_m - y);
        this.pointers = new Map();
        this.drawPicture();
        this.drawReference(data.reference);
        this.drawEnds();
        this.listen();
    }

    part(name) { return this.svg.querySelector("." + name); }

    drawPicture() {
        const picture = this.part("picture");
        picture.setAttribute("href", this.area.image);
        picture.setAttribute("width", this.area.width_m);
        picture.setAttribute("height", this.area.height_m);
    }

    drawReference(reference) {
        if (reference) {
            const points = reference.x_m.map((x, i) =>
                `${x - this.area.left_m} ${this.area.bottom_m + this.area.height_m - reference.y_m[i]}`);
            this.part("reference").setAttribute("d", "M" + points.join("L"));
        }
    }

    drawEnds() {
        for (const [name, row] of [["start", 0], ["end", this.x.length - 1]]) {
            this.place(this.part(name), row);
        }
    }

    place(circle, row) {
        circle.setAttribute("visibility", row in this.x ? "visible" : "hidden");
        if (row in this.x) {
            circle.setAttribute("cx", this.x[row]);
            circle.setAttribute("cy", this.y[row]);
        }
    }

    /** Colours the path: each piece by the value at its end. */
    colourBy(values, [low, high]) {
        const pieces = Array.from({ length: HEAT_STEPS }, () => "");
        for (let row = 1; row < this.x.length; ++row) {
            const share = ((values[row] ?? low) - low) / (high - low || 1);
            const step = Math.min(HEAT_STEPS - 1, Math.max(0, Math.floor(share * HEAT_STEPS)));
            pieces[step] += `M${this.x[row - 1]} ${this.y[row - 1]}L${this.x[row]} ${this.y[row]}`;
        }
        this.part("heat").replaceChildren(...pieces.map((d, step) => {
            const path = document.createElementNS(this.svg.namespaceURI, "path");
            path.setAttribute("class", "heat-" + step);
            path.setAttribute("d", d);
            return path;
        }));
    }

    show(row, words) {
        this.place(this.part("here"), row);
        this.element.querySelector(".readout").textContent = words;
    }

    /** Brings the row's place into the middle, near enough to see what is around it. */
    centre(row) {
        if (row in this.x) {
            const width = Math.min(this.view.width, Math.max(6, 0.15 * this.fitWidth()));
            this.look({ x: this.x[row] - width / 2, y: this.y[row] - width * this.aspect() / 2, width });
        }
    }

    aspect() { return this.element.clientHeight / Math.max(1, this.element.clientWidth); }
    metresPerPixel() { return this.view.width / Math.max(1, this.element.clientWidth); }
    fitWidth() { return 1.04 * Math.max(this.area.width_m, this.area.height_m / this.aspect()); }

    fit() {
        const width = this.fitWidth();
        this.look({
            x: (this.area.width_m - width) / 2,
            y: (this.area.height_m - width * this.aspect()) / 2,
            width,
        });
    }

    look(view) {
        this.view = view;
        this.svg.setAttribute("viewBox", `${view.x} ${view.y} ${view.width} ${view.width * this.aspect()}`);
        for (const circle of this.svg.querySelectorAll("circle")) {
            circle.setAttribute("r", circle.dataset.px * this.metresPerPixel());
        }
        const bar = roundLength(0.25 * view.width);
        const scale = this.element.querySelector(".scale");
        scale.style.width = `${bar / this.metresPerPixel()}px`;
        scale.firstElementChild.textContent = `${bar} m`;
    }

    /** factor < 1 looks closer; the point of the element stays where it is. */
    zoom(factor, pixelX = this.element.clientWidth / 2, pixelY = this.element.clientHeight / 2) {
        const width = Math.min(2 * this.fitWidth(), Math.max(this.fitWidth() / MOST_ZOOM, this.view.width * factor));
        const before = this.metresPerPixel();
        const change = before - before * width / this.view.width;
        this.look({ x: this.view.x + pixelX * change, y: this.view.y + pixelY * change, width });
    }

    pan(pixelsX, pixelsY) {
        const metres = this.metresPerPixel();
        this.look({ ...this.view, x: this.view.x - pixelsX * metres, y: this.view.y - pixelsY * metres });
    }

    pixel(event) {
        const box = this.element.getBoundingClientRect();
        return { x: event.clientX - box.left, y: event.clientY - box.top };
    }

    /** The row of the place nearest to a pixel; none if it is far away. */
    rowAt(pixel) {
        const metres = this.metresPerPixel();
        let nearest = -1;
        let distance = NEAR_PX * metres;
        for (let row = 0; row < this.x.length; ++row) {
            const apart = Math.hypot(this.x[row] - this.view.x - pixel.x * metres, this.y[row] - this.view.y - pixel.y * metres);
            if (apart < distance) {
                [nearest, distance] = [row, apart];
            }
        }
        return nearest;
    }

    listen() {
        new ResizeObserver(() => this.view ? this.look(this.view) : this.fit()).observe(this.element);
        this.element.addEventListener("wheel", event => {
            event.preventDefault();
            const pixel = this.pixel(event);
            this.zoom(Math.exp(0.0015 * event.deltaY), pixel.x, pixel.y);
        }, { passive: false });
        this.element.addEventListener("click", event => this.press(event.target.dataset.zoom));
        this.element.addEventListener("keydown", event => this.key(event));
        this.svg.addEventListener("pointerdown", event => this.grab(event));
        this.svg.addEventListener("pointermove", event => this.move(event));
        for (const end of ["pointerup", "pointercancel"]) {
            this.svg.addEventListener(end, event => this.release(event));
        }
    }

    press(zoom) {
        if (zoom !== undefined) {
            Number(zoom) === 0 ? this.fit() : this.zoom(Number(zoom));
        }
    }

    key(event) {
        const step = 60;
        const actions = {
            ArrowLeft: () => this.pan(step, 0),
            ArrowRight: () => this.pan(-step, 0),
            ArrowUp: () => this.pan(0, step),
            ArrowDown: () => this.pan(0, -step),
            "+": () => this.zoom(0.7),
            "=": () => this.zoom(0.7),
            "-": () => this.zoom(1.4),
            0: () => this.fit(),
        };
        if (actions[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
            event.preventDefault();
            actions[event.key]();
        }
    }

    grab(event) {
        this.svg.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, this.pixel(event));
        this.grabbed = this.pixel(event);
    }

    release(event) {
        const pixel = this.pixel(event);
        const still = this.grabbed && Math.hypot(pixel.x - this.grabbed.x, pixel.y - this.grabbed.y) < CLICK_PX;
        if (event.type === "pointerup" && this.pointers.size === 1 && still) {
            this.point(pixel);
        }
        this.pointers.delete(event.pointerId);
    }

    move(event) {
        const now = this.pixel(event);
        const before = this.pointers.get(event.pointerId);
        if (!before) {
            this.point(now);
            return;
        }
        const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, pixel]) => pixel);
        if (others.length === 1) {
            this.pinch(others[0], before, now);
        } else if (others.length === 0) {
            this.pan(now.x - before.x, now.y - before.y);
        }
        this.pointers.set(event.pointerId, now);
    }

    pinch(fixed, before, now) {
        const apart = pixel => Math.max(1, Math.hypot(pixel.x - fixed.x, pixel.y - fixed.y));
        this.zoom(apart(before) / apart(now), fixed.x, fixed.y);
    }

    point(pixel) {
        const row = this.rowAt(pixel);
        if (row >= 0) {
            this.onRow(row);
        }
    }
}
