// Joins the map and the time lines of the page, and the buttons that lead to a row of them.

const LEGEND_MARKUP = `
<div class="legend">
  <label>Path coloured by <select></select></label>
  <span class="low"></span><span class="ramp" aria-hidden="true"></span><span class="high"></span>
  <span class="reference-key" hidden></span>
</div>`;

function legendOf(data, map) {
    const legend = elementOf(LEGEND_MARKUP);
    const select = legend.querySelector("select");
    data.lines.forEach((line, index) => select.add(new Option(withUnit(line.name, line.unit && `[${line.unit}]`), index)));
    for (let step = 0; step < HEAT_STEPS; ++step) {
        legend.querySelector(".ramp").append(elementOf(`<i class="heat-${step}"></i>`));
    }
    const colour = () => {
        const line = data.lines[select.value];
        const range = lineRange(line);
        map.colourBy(line.values, range);
        [".low", ".high"].forEach((end, index) => legend.querySelector(end).textContent = shortNumber(range[index]));
    };
    select.addEventListener("change", colour);
    colour();
    if (data.reference) {
        const key = legend.querySelector(".reference-key");
        key.textContent = data.reference.name;
        key.hidden = false;
    }
    return legend;
}

function startExplorer() {
    const data = JSON.parse(document.getElementById("explorer-data").textContent);
    const holder = document.getElementById("explorer");
    const show = row => {
        lines.show(row);
        map.show(row, lines.words(row));
    };
    const pick = row => {
        show(row);
        map.centre(row);
    };
    const map = new MapView(data, show);
    const lines = new TimeLines(data, show, pick);
    const mapSide = elementOf(`<div class="map-side"></div>`);
    mapSide.append(map.element);
    holder.append(mapSide);
    if (data.lines.length > 0) {
        mapSide.append(legendOf(data, map));
        holder.append(lines.element);
    }
    for (const button of document.querySelectorAll("button[data-row]")) {
        button.addEventListener("click", () => {
            pick(Number(button.dataset.row));
            holder.scrollIntoView({ block: "nearest" });
        });
    }
}

startExplorer();
