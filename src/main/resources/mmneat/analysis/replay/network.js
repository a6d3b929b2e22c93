/* The sensor values and the network's output in each direction, and the network with its activations in one direction. */
const DIRECTION_NAMES = ["up", "right", "down", "left"], DIRECTION_SIGNS = ["↑", "→", "↓", "←"];
const EXCITES = [120, 190, 255], INHIBITS = [255, 96, 72], PREFERENCE_GREY = "#aab1c8";

class NetworkView {
  constructor(recording, canvas) {
    this.recording = recording;
    this.canvas = canvas;
    this.network = recording.network;
    this.follow = -1;
    this.lastOpen = DIRECTION_NAMES.map((_, direction) => this.listLastOpen(direction));
  }

  /** For each step, the latest step up to it in which the direction is open; if there is none yet, the first such step. */
  listLastOpen(direction) {
    const open = this.recording.column["preference" + direction], last = new Uint32Array(open.length);
    let found = Math.max(0, open.findIndex(value => value !== WALL));
    for (let i = 0; i < open.length; i++) last[i] = open[i] !== WALL ? found = i : found;
    return last;
  }

  /** The step whose evaluation is shown. If the direction is a wall, the last step in which it was open. */
  networkStep(direction, step) { return this.lastOpen[direction][step]; }

  /** The direction whose network is shown: the direction of the move, unless the reader selected another. */
  direction(step) {
    if (this.follow >= 0) return this.follow;
    const { choice, module } = this.recording.column;
    const decided = module[step] === WALL && step > 0 ? step - 1 : step;
    return choice[decided] < 4 ? choice[decided] : 0;
  }

  value(kind, direction, index, step) {
    const { column, detailEvery, sensorScale, activationScale } = this.recording;
    const scale = kind === "sensor" ? sensorScale : activationScale;
    return column[`${kind}${direction}_${index}`][Math.floor(step / detailEvery)] / scale - 1;
  }

  /** The sentence that names the deciding module and its direction. */
  decision(step) {
    const { column } = this.recording, direction = column.choice[step];
    if (column.module[step] === WALL || direction > 3) return "The game is over";
    return `${capital(this.network.modules[column.module[step]])} decides: ${DIRECTION_SIGNS[direction]} ${DIRECTION_NAMES[direction]}`;
  }

  isOpen(direction, step) { return this.recording.column["preference" + direction][step] !== WALL; }

  preference(direction, step) { return this.recording.column["preference" + direction][step] / this.recording.sensorScale - 1; }

  layOut(width, height) {
    const inputs = this.network.inputs.length;
    const small = width < 560;
    const at = this.at = { width, height, small };
    at.label = small ? Math.min(150, width * .41) : Math.min(210, width * .3);
    at.cell = small ? 17 : Math.max(24, Math.min(46, width * .05));
    at.top = 50;
    at.row = (height - at.top - 4) / Math.max(1, inputs);
    at.first = at.label + 4 * at.cell + 12;
    at.last = width - (small ? 26 : 44);
    const y = this.network.inputs.map((_, i) => at.top + (i + .5) * at.row);
    const x = this.network.inputs.map(() => at.first);
    this.placeOutputs(x, y, inputs, at);
    this.placeHidden(x, y, inputs, at);
    at.x = x; at.y = y;
  }

  /** Places the outputs of each module in a box, as in the paper's Figure 1. */
  placeOutputs(x, y, inputs, at) {
    const slot = (at.height - at.top) / this.network.modules.length;
    at.boxes = this.network.modules.map((_, module) => {
      const outputs = this.network.nodes.map((n, i) => i).filter(i => this.network.nodes[i].module === module);
      const gap = Math.min(34, (slot - 14) / (outputs.length + .2)), middle = at.top + (module + .5) * slot + 7;
      outputs.forEach((i, k) => { x[inputs + i] = at.last; y[inputs + i] = middle + (k - (outputs.length - 1) / 2) * gap; });
      const tall = (outputs.length - 1) * gap + Math.min(34, gap + 8);
      return { top: middle - tall / 2, height: tall, radius: Math.max(3, Math.min(9, gap * .38)) };
    });
  }

  /** Places hidden nodes by layer (x) and at the mean of their neighbours (y), moved apart where they would overlap. */
  placeHidden(x, y, inputs, at) {
    const hidden = this.network.nodes.map((n, i) => i).filter(i => this.network.nodes[i].kind === "HIDDEN");
    const ends = hidden.map(i => this.network.links.flatMap(l =>
      l.target === inputs + i && l.source !== inputs + i ? [l.source] : l.source === inputs + i && l.target !== inputs + i ? [l.target] : []));
    hidden.forEach(i => { x[inputs + i] = at.first + 24 + (at.last - at.first - 56) * this.network.nodes[i].layer; y[inputs + i] = (at.top + at.height) / 2; });
    for (let round = 0; round < 4; round++) {
      hidden.forEach((i, k) => { if (ends[k].length) y[inputs + i] = ends[k].reduce((sum, e) => sum + y[e], 0) / ends[k].length; });
    }
    const placed = [];
    const order = hidden.slice().sort((a, b) => y[inputs + a] - y[inputs + b]);
    for (const i of order) {
      let shift = 0;
      const clash = yy => placed.some(p => Math.hypot(x[p] - x[inputs + i], y[p] - yy) < 17);
      const base = y[inputs + i];
      while (shift < at.height && (clash(y[inputs + i]) || y[inputs + i] < at.top + 8 || y[inputs + i] > at.height - 10)) {
        shift = shift > 0 ? -shift : 6 - shift;
        y[inputs + i] = base + shift;
      }
      placed.push(inputs + i);
    }
  }

  draw(step) {
    if (!this.network.inputs.length) return;
    const surface = sharp(this.canvas);
    if (!surface) return;
    const { context: c, width, height } = surface;
    if (!this.at || this.at.width !== width || this.at.height !== height) this.layOut(width, height);
    const shown = `${step} ${this.follow} ${this.canvas.width} ${this.canvas.height}`;
    if (shown === this.shown) return;
    this.shown = shown;
    c.clearRect(0, 0, width, height);
    const { module } = this.recording.column;
    const decided = module[step] === WALL && step > 0 ? step - 1 : step;
    const direction = this.direction(decided), evaluated = this.networkStep(direction, decided);
    this.drawDirections(c, decided, direction);
    this.drawSensors(c, decided, direction);
    this.drawNetwork(c, evaluated, direction);
    if (evaluated !== decided) {
      c.fillStyle = "#8f99bd"; c.textAlign = "left"; c.textBaseline = "middle"; c.font = "12px system-ui, sans-serif";
      const late = decided - evaluated, steps = Math.abs(late) === 1 ? "step" : "steps";
      const when = late > 0 ? `of ${late} ${steps} ago` : `in ${-late} ${steps}`;
      c.fillText(fit(c, this.at.small ? `wall; ${when}` : `${DIRECTION_SIGNS[direction]} is a wall; activations ${when}`, width - this.at.first - 14), this.at.first + 8, 12);
    }
  }

  drawDirections(c, step, shown) {
    const { at } = this, { choice, module } = this.recording.column;
    c.textAlign = "left"; c.textBaseline = "middle"; c.font = "12px system-ui, sans-serif"; c.fillStyle = "#8f99bd";
    c.fillText("output", 2, 33);
    for (let d = 0; d < 4; d++) {
      const x = at.label + d * at.cell, w = at.cell - 3;
      if (d === shown) { c.fillStyle = "#1c2548"; c.beginPath(); c.roundRect(x - 1.5, 0, at.cell, at.height, 6); c.fill(); }
      const open = this.isOpen(d, step), chosen = choice[step] === d;
      c.textAlign = "center"; c.font = `${chosen ? 700 : 400} 15px system-ui, sans-serif`;
      c.fillStyle = !open ? "#3d4670" : chosen ? "#ffd84a" : "#e9ecf8";
      c.fillText(DIRECTION_SIGNS[d], x + w / 2, 12);
      if (!open) continue;
      const colour = moduleColour(this.recording.column["moduleOf" + d][step]), value = this.preference(d, step);
      c.fillStyle = "#070a16"; c.fillRect(x, 23, w, 19);
      c.fillStyle = colour; c.globalAlpha = chosen ? 1 : .55;
      const middle = x + w / 2;
      c.fillRect(Math.min(middle, middle + value * w / 2), 23, Math.max(1, Math.abs(value) * w / 2), 19);
      c.globalAlpha = 1;
      if (chosen) { c.strokeStyle = "#ffd84a"; c.lineWidth = 1.5; c.strokeRect(x - .5, 22.5, w + 1, 20); }
    }
  }

  drawSensors(c, step, shown) {
    const { at } = this, bar = Math.min(12, at.row - 3);
    c.textBaseline = "middle";
    const size = Math.max(9, Math.min(at.small ? 10.5 : 12.5, at.row - 2));
    this.network.inputs.forEach((label, i) => {
      const y = at.top + (i + .5) * at.row;
      c.font = `${size}px system-ui, sans-serif`; c.textAlign = "left"; c.fillStyle = "#c3cae6";
      c.fillText(fit(c, label, at.label - 8), 2, y);
      for (let d = 0; d < 4; d++) {
        const x = at.label + d * at.cell, w = at.cell - 3;
        if (!this.isOpen(d, step)) { c.fillStyle = "#232b4c"; c.fillRect(x + w / 2 - 2, y - .5, 4, 1); continue; }
        const value = this.value("sensor", d, i, step);
        c.fillStyle = "#070a16"; c.fillRect(x, y - bar / 2, w, bar);
        c.fillStyle = value < 0 ? "#ff6048" : d === shown ? "#9ccfff" : "#6f7cae";
        c.fillRect(x, y - bar / 2, Math.abs(value) * w, bar);
      }
    });
  }

  activation(end, direction, step) {
    const inputs = this.network.inputs.length;
    return end < inputs ? Math.tanh(this.value("sensor", direction, end, step)) : this.value("node", direction, end - inputs, step);
  }

  drawNetwork(c, step, direction) {
    const { at, network } = this, inputs = network.inputs.length;
    const before = Math.max(0, step - this.recording.detailEvery);
    const signal = network.links.map(l => l.weight * this.activation(l.source, direction, l.recurrent ? before : step));
    this.drawBoxes(c, this.recording.column["moduleOf" + direction][step]);
    const order = network.links.map((_, i) => i).sort((a, b) => Math.abs(signal[a]) - Math.abs(signal[b]));
    for (const i of order) {
      const link = network.links[i], strength = Math.min(1, Math.abs(signal[i]));
      c.strokeStyle = `rgba(${(signal[i] >= 0 ? EXCITES : INHIBITS).join()},${.07 + .75 * strength})`;
      c.lineWidth = .6 + Math.min(1.8, Math.abs(link.weight) * .45) * (.4 + .6 * strength);
      this.drawLink(c, link);
    }
    const winner = this.recording.column["moduleOf" + direction][step];
    network.nodes.forEach((node, i) => this.drawNode(c, node, inputs + i, this.activation(inputs + i, direction, step), winner));
    for (let i = 0; i < inputs; i++) this.dot(c, at.x[i], at.y[i], 2.6, this.activation(i, direction, step), "#3a4470");
  }

  drawLink(c, { source, target, recurrent }) {
    const { x, y } = this.at, x1 = x[source], y1 = y[source], x2 = x[target], y2 = y[target];
    c.setLineDash(recurrent ? [3, 3] : []);
    c.beginPath();
    if (source === target) c.arc(x1, y1 - 10, 8, 0, 2 * Math.PI);
    else {
      c.moveTo(x1, y1);
      const bend = recurrent ? 30 : 0, pull = Math.max(16, Math.abs(x2 - x1) * .45);
      if (x2 > x1) c.bezierCurveTo(x1 + pull, y1 + bend, x2 - pull, y2 + bend, x2, y2);
      else c.bezierCurveTo(x1 + 24, y1 + 26, x2 - 24, y2 + 26, x2, y2);
    }
    c.stroke();
    c.setLineDash([]);
  }

  drawBoxes(c, winner) {
    const { at } = this, half = at.small ? 18 : 22;
    this.network.modules.forEach((name, module) => {
      const { top, height } = at.boxes[module], wins = module === winner, colour = moduleColour(module);
      c.globalAlpha = wins ? 1 : .6;
      c.fillStyle = wins ? "#1c2548" : "#141a34"; c.strokeStyle = colour; c.lineWidth = wins ? 2 : 1;
      if (wins) { c.shadowColor = colour; c.shadowBlur = 14; }
      c.beginPath(); c.roundRect(at.last - half, top, 2 * half, height, 7); c.fill();
      c.shadowBlur = 0;
      c.stroke();
      c.font = `${wins ? 700 : 500} ${at.small ? 11 : 12.5}px system-ui, sans-serif`;
      c.textAlign = "left"; c.textBaseline = "bottom"; c.fillStyle = colour;
      const text = at.small ? "M" + (module + 1) : fit(c, capital(name), (at.last - at.first) / 2), wide = c.measureText(text).width;
      c.fillText(text, Math.min(at.last - wide / 2, at.width - wide - 2), top - 3);
      c.globalAlpha = 1;
    });
  }

  drawNode(c, node, end, activation, winner) {
    const { at } = this, x = at.x[end], y = at.y[end];
    if (node.kind === "HIDDEN") { this.dot(c, x, y, 5.5, activation, "#6a76aa"); return; }
    const { radius } = at.boxes[node.module], wins = node.module === winner;
    if (node.kind === "POLICY") this.dot(c, x, y, radius, activation, wins ? "#fff" : "#c3cae6", wins ? 2.4 : 1.2);
    else this.dot(c, x, y, radius * .85, activation, PREFERENCE_GREY, wins ? 2.4 : 1.2, true);
  }

  dot(c, x, y, radius, activation, edge, line = 1.2, diamond = false) {
    const mix = Math.min(1, Math.abs(activation)), to = activation >= 0 ? EXCITES : INHIBITS;
    c.fillStyle = `rgb(${[14, 19, 40].map((from, i) => Math.round(from + (to[i] - from) * mix)).join()})`;
    c.strokeStyle = edge; c.lineWidth = line;
    c.beginPath();
    if (diamond) { c.moveTo(x, y - radius - 1); c.lineTo(x + radius + 1, y); c.lineTo(x, y + radius + 1); c.lineTo(x - radius - 1, y); c.closePath(); }
    else c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fill(); c.stroke();
  }

  /** The text with the values at the pointer, or null. */
  describe(px, py, step) {
    const { at, network } = this;
    if (!at) return null;
    const near = at.x.findIndex((x, i) => i >= network.inputs.length && Math.hypot(x - px, at.y[i] - py) < 10);
    if (near >= 0) {
      const node = network.nodes[near - network.inputs.length], direction = this.direction(step), evaluated = this.networkStep(direction, step);
      const kind = node.kind === "HIDDEN" ? "hidden node" : `${node.kind.toLowerCase()} of ${network.modules[node.module]}`;
      return `${kind}, ${DIRECTION_NAMES[direction]}: ` + this.activation(near, direction, evaluated).toFixed(2);
    }
    const row = Math.floor((py - at.top) / at.row);
    if (row < 0 || row >= network.inputs.length || px > at.first + 8) return null;
    const values = DIRECTION_SIGNS.map((sign, d) => `${sign} ${this.isOpen(d, step) ? this.value("sensor", d, row, step).toFixed(2) : "wall"}`);
    return network.inputs[row] + "\n" + values.join("   ");
  }
}

/** Shortens a text to a width. */
function fit(c, text, width) {
  if (c.measureText(text).width <= width) return text;
  let shorter = text;
  while (shorter.length > 2 && c.measureText(shorter + "…").width > width) shorter = shorter.slice(0, -1);
  return shorter.trimEnd() + "…";
}
