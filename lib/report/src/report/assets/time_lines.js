// Lines over a common axis, one strip below the other, with a cursor through all of them.

const PLOT_WIDTH = 1000;  // of a strip's own coordinates, which the page stretches
const PLOT_HEIGHT = 100;
const LARGE_STEP = 0.05;  // of all rows, for the keys Page Up and Page Down

const STRIP_MARKUP = `
<div class="strip">
  <div class="head"><span class="name"></span><output></output></div>
  <div class="plot">
    <svg viewBox="0 0 ${PLOT_WIDTH} ${PLOT_HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
      <path class="events"></path><path class="curve"></path>
    </svg>
    <span class="high"></span><span class="low"></span><div class="cursor" hidden></div>
  </div>
</div>`;

/** Four digits at most; no more than a reader takes in. */
function shortNumber(value) {
    return Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "\u2013";
}

function withUnit(text, unit) {
    return unit ? `${text} ${unit}` : text;
}

class TimeLines {
    /** onRow(row): the cursor is to go there. onPick(row): the map, too. */
    constructor(data, onRow, onPick) {
        this.data = data;
        this.onRow = onRow;
        this.onPick = onPick;
        this.x = data.x.values;
        this.range = rangeOf(this.x);
        this.row = -1;
        this.element = elementOf(`<div class="lines" tabindex="0" role="slider"></div>`);
        this.element.setAttribute("aria-label", data.x.name);
        this.element.setAttribute("aria-valuemin", this.range[0]);
        this.element.setAttribute("aria-valuemax", this.range[1]);
        this.element.setAttribute("aria-valuenow", this.range[0]);
        this.strips = data.lines.map(line => this.strip(line));
        this.element.append(...this.strips, this.axis());
        this.listen();
    }

    share(row) { return (this.x[row] - this.range[0]) / (this.range[1] - this.range[0] || 1); }

    strip(line) {
        const strip = elementOf(STRIP_MARKUP);
        const [low, high] = lineRange(line);
        strip.querySelector(".name").textContent = withUnit(line.name, line.unit && `[${line.unit}]`);
        strip.querySelector(".low").textContent = shortNumber(low);
        strip.querySelector(".high").textContent = shortNumber(high);
        strip.querySelector(".curve").setAttribute("d", this.curve(line.values, low, high));
        strip.querySelector(".events").setAttribute("d", (line.events || []).map(row =>
            `M${this.share(row) * PLOT_WIDTH} ${PLOT_HEIGHT}v-${0.2 * PLOT_HEIGHT}`).join(""));
        return strip;
    }

    curve(values, low, high) {
        let draws = false;
        return values.map((value, row) => {
            const command = draws ? "L" : "M";
            draws = Number.isFinite(value);
            const y = PLOT_HEIGHT * (1 - (value - low) / (high - low));
            return draws ? `${command}${(this.share(row) * PLOT_WIDTH).toFixed(2)} ${y.toFixed(2)}` : "";
        }).join("");
    }

    axis() {
        const axis = elementOf(`<div class="axis"></div>`);
        const [low, high] = this.range;
        const step = roundLength(Math.max(high - low, 1e-9) / 3);
        for (let tick = Math.ceil(low / step) * step; tick <= high; tick += step) {
            const mark = elementOf("<span></span>");
            mark.style.left = `${100 * (tick - low) / (high - low || 1)}%`;
            mark.textContent = shortNumber(tick);
            axis.append(mark);
        }
        axis.append(elementOf("<b></b>"));
        axis.lastElementChild.textContent = `${this.data.x.name} [${this.data.x.unit}]`;
        return axis;
    }

    /** All that is known of a row, in words. */
    words(row) {
        const named = [this.data.x, ...this.data.lines];
        return named.map(line => withUnit(`${line.name} ${shortNumber(line.values[row])}`, line.unit)).join(", ");
    }

    show(row) {
        this.row = row;
        this.strips.forEach((strip, index) => {
            const line = this.data.lines[index];
            strip.querySelector("output").textContent = withUnit(shortNumber(line.values[row]), line.unit);
            const cursor = strip.querySelector(".cursor");
            cursor.hidden = false;
            cursor.style.left = `${100 * this.share(row)}%`;
        });
        this.element.setAttribute("aria-valuenow", this.x[row]);
        this.element.setAttribute("aria-valuetext", this.words(row));
    }

    /** The row nearest to the pointer. */
    rowAt(event) {
        const box = this.strips[0].querySelector(".plot").getBoundingClientRect();
        const share = (event.clientX - box.left) / Math.max(1, box.width);
        let nearest = 0;
        for (let row = 1; row < this.x.length; ++row) {
            if (Math.abs(this.share(row) - share) < Math.abs(this.share(nearest) - share)) {
                nearest = row;
            }
        }
        return nearest;
    }

    listen() {
        this.element.addEventListener("pointermove", event => this.onRow(this.rowAt(event)));
        this.element.addEventListener("click", event => this.onPick(this.rowAt(event)));
        this.element.addEventListener("keydown", event => this.key(event));
    }

    key(event) {
        const last = this.x.length - 1;
        const large = Math.max(1, Math.round(LARGE_STEP * last));
        const rows = {
            ArrowLeft: this.row - 1,
            ArrowRight: this.row + 1,
            PageDown: this.row - large,
            PageUp: this.row + large,
            Home: 0,
            End: last,
        };
        if (event.key in rows) {
            event.preventDefault();
            this.onRow(Math.min(last, Math.max(0, rows[event.key])));
        } else if (event.key === "Enter") {
            this.onPick(Math.max(0, this.row));
        }
    }
}

/** What a strip shows: the line's own limits where it has some, else all its values and zero. */
function lineRange(line) {
    const [least, largest] = rangeOf(line.values);
    const low = line.low ?? Math.min(0, least);
    const high = line.high ?? largest;
    return high > low ? [low, high] : [low, low + 1];
}
