/* Controls: playing, stepping, scrubbing, the numbers and the keyboard. */
const STEPS_PER_SECOND = 25, SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16], EVENT_MILLISECONDS = 900;

class Player {
  constructor(recording) {
    this.recording = recording;
    this.at = 0;
    this.speed = 2;
    this.playing = false;
    this.holdUntil = 0;
    this.byId = id => document.getElementById(id);
    this.maze = new MazeView(recording, this.byId("maze-canvas"));
    this.networkView = new NetworkView(recording, this.byId("network-canvas"));
    this.timeline = new Timeline(recording, this.byId("timeline-canvas"));
    document.body.classList.toggle("no-network", recording.network.inputs.length === 0);
    document.body.classList.toggle("one-life", Math.max(...new Set(recording.column.lives)) <= 1);
    document.body.classList.toggle("one-game", recording.gameStarts.length === 1);
    this.byId("network-canvas").style.setProperty("--inputs", recording.network.inputs.length);
    this.listModules();
    this.connect();
    this.seek(0);
    this.time = performance.now();
    requestAnimationFrame(now => this.frame(now));
  }

  get last() { return this.recording.steps - 1; }
  get step() { return Math.min(this.last, Math.floor(this.at)); }

  frame(now) {
    const elapsed = Math.min(100, now - this.time) / 1000;
    this.time = now;
    if (this.playing && now >= this.holdUntil) {
      this.advance(elapsed * STEPS_PER_SECOND * this.speed, now);
      this.show();
    }
    this.maze.draw(this.at, now);
    this.networkView.draw(this.step);
    this.timeline.draw(this.at);
    requestAnimationFrame(next => this.frame(next));
  }

  /** Advances the position. At the end of a life or a game, it pauses briefly so that the message can be read. */
  advance(steps, now) {
    const to = Math.min(this.last, this.at + steps);
    const event = this.recording.events.find(e => e.step > this.at && e.step <= to && e.step < this.last);
    this.at = event ? event.step : to;
    if (event) this.holdUntil = now + EVENT_MILLISECONDS;
    if (this.at >= this.last) this.pause();
  }

  play() {
    if (this.at >= this.last) this.at = 0;
    this.playing = true;
    this.byId("poster").hidden = true;
    this.showPlaying();
  }

  pause() { this.playing = false; this.showPlaying(); }
  toggle() { this.playing ? this.pause() : this.play(); }

  seek(step) {
    this.at = Math.max(0, Math.min(this.last, step));
    this.show();
  }

  move(steps) { this.pause(); this.byId("poster").hidden = true; this.seek(this.step + steps); }

  chapter(change) {
    const chapters = this.recording.chapters, now = chapters.indexOf(chapterAt(this.recording, this.step));
    const back = change < 0 && this.step - chapters[now].step > 40 ? 0 : change;
    const target = chapters[now + back];
    this.seek(target ? target.step : change < 0 ? 0 : this.last);
  }

  setSpeed(speed) {
    this.speed = speed;
    for (const button of this.byId("speeds").children) button.setAttribute("aria-checked", String(+button.dataset.speed === speed));
  }

  faster(change) { this.setSpeed(SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, SPEEDS.indexOf(this.speed) + change))]); }

  setDirection(direction) {
    this.networkView.follow = direction;
    for (const button of this.byId("directions").children) button.setAttribute("aria-checked", String(+button.dataset.direction === direction));
  }

  listModules() {
    const { column, network } = this.recording, counts = new Map();
    this.byId("preference-key").hidden = !network.nodes.some(node => node.kind === "PREFERENCE");
    this.byId("recurrent-key").hidden = !network.links.some(link => link.recurrent);
    for (const module of column.module) if (module !== WALL) counts.set(module, (counts.get(module) || 0) + 1);
    const total = [...counts.values()].reduce((a, b) => a + b, 0) || 1;
    network.modules.forEach((name, m) => {
      const item = document.createElement("li"), swatch = document.createElement("i");
      swatch.style.setProperty("--c", moduleColour(m));
      item.append(swatch, `${capital(name)} · ${(100 * (counts.get(m) || 0) / total).toFixed(1)}%`);
      this.byId("modules").append(item);
    });
  }

  show() {
    const step = this.step, { column, steps, ghostsEaten, events, total } = this.recording;
    const chapter = chapterAt(this.recording, step), left = pillsAt(this.recording, chapter, step);
    const number = value => value.toLocaleString("en");
    const put = (id, text) => { const e = this.byId(id); if (e.textContent !== text) e.textContent = text; };
    put("score", number(column.score[step]));
    put("total", number(total[step]));
    put("maze-label", `${chapter.game || `Level ${chapter.level + 1}`} maze`);
    put("maze", mazeLetter(chapter));
    put("pills", left.powerPills.size ? `${left.pills.size}+${left.powerPills.size}` : String(left.pills.size));
    put("ghosts", String(ghostsEaten[step]));
    put("lives", String(column.lives[step]));
    put("position", `${number(step)} / ${number(steps - 1)}`);
    const slider = this.byId("timeline");
    slider.setAttribute("aria-valuemax", steps - 1);
    slider.setAttribute("aria-valuenow", step);
    slider.setAttribute("aria-valuetext", `step ${step}, ${chapterName(chapter)}, score ${column.score[step]}`);
    [...this.byId("modules").children].forEach((item, m) => item.classList.toggle("now", column.module[step] === m));
    put("decision", this.networkView.decision(step));
    const event = events.find(e => step === e.step);
    this.byId("outcome").hidden = !event;
    if (!event) return;
    put("outcome", event.text);
    // The message appears in the half of the maze where the event did not happen.
    const { y } = this.recording.mazeOf[chapter.maze];
    this.byId("outcome").classList.toggle("high", y[column.node[step]] > Math.max(...y) / 2);
  }

  showPlaying() {
    const button = this.byId("play");
    button.classList.toggle("playing", this.playing);
    button.setAttribute("aria-label", this.playing ? "Pause" : "Play");
  }

  connect() {
    const click = (id, action) => this.byId(id).addEventListener("click", action);
    click("play", () => this.toggle());
    click("poster", () => this.play());
    click("maze-canvas", () => this.toggle());
    click("back", () => this.move(-1));
    click("forward", () => this.move(1));
    click("previous", () => this.chapter(-1));
    click("next", () => this.chapter(1));
    click("help-button", () => this.byId("help").showModal());
    for (const speed of SPEEDS) this.choice("speeds", { speed }, speed < 1 ? { 0.25: "¼", 0.5: "½" }[speed] : speed + "×", () => this.setSpeed(speed));
    this.setSpeed(2);
    [-1, 0, 1, 2, 3].forEach(direction => {
      const label = direction < 0 ? "chosen" : DIRECTION_SIGNS[direction];
      this.choice("directions", { direction }, label, () => this.setDirection(direction), direction < 0 ? "the chosen direction" : DIRECTION_NAMES[direction]);
    });
    this.setDirection(-1);
    this.connectTimeline();
    this.connectTip();
    document.addEventListener("keydown", event => this.key(event));
  }

  choice(group, data, label, action, name) {
    const button = document.createElement("button");
    Object.assign(button.dataset, data);
    button.textContent = label;
    button.setAttribute("role", "radio");
    if (name) button.setAttribute("aria-label", name);
    button.addEventListener("click", action);
    this.byId(group).append(button);
  }

  connectTimeline() {
    const strip = this.byId("timeline");
    const scrub = event => {
      const box = strip.getBoundingClientRect();
      this.byId("poster").hidden = true;
      this.seek(this.timeline.step(event.clientX - box.left, box.width));
    };
    strip.addEventListener("pointerdown", event => { strip.setPointerCapture(event.pointerId); scrub(event); });
    strip.addEventListener("pointermove", event => { if (event.buttons) scrub(event); });
  }

  connectTip() {
    const canvas = this.byId("network-canvas"), tip = this.byId("tip");
    const tell = event => {
      const box = canvas.getBoundingClientRect(), outer = canvas.parentElement.getBoundingClientRect();
      const text = this.networkView.describe(event.clientX - box.left, event.clientY - box.top, this.step);
      tip.hidden = !text;
      if (!text) return;
      tip.textContent = text;
      tip.style.left = Math.min(event.clientX - outer.left + 14, outer.width - tip.offsetWidth - 8) + "px";
      tip.style.top = event.clientY - outer.top + 16 + "px";
    };
    canvas.addEventListener("pointermove", tell);
    canvas.addEventListener("pointerdown", tell);
    canvas.addEventListener("pointerleave", () => { tip.hidden = true; });
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || this.byId("help").open) return;
    const far = event.shiftKey ? 25 : 1;
    const actions = {
      " ": () => this.toggle(), ArrowLeft: () => this.move(-far), ArrowRight: () => this.move(far),
      ArrowUp: () => this.faster(1), ArrowDown: () => this.faster(-1), Home: () => this.seek(0), End: () => { this.pause(); this.byId("poster").hidden = true; this.seek(this.last); },
      n: () => this.chapter(1), p: () => this.chapter(-1), d: () => this.setDirection((this.networkView.follow + 2) % 5 - 1),
      t: () => { this.maze.trailShown = !this.maze.trailShown; }, h: () => this.byId("help").showModal(), "?": () => this.byId("help").showModal(),
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

readRecording(document.getElementById("replay")).then(recording => { window.player = new Player(recording); }).catch(error => {
  document.getElementById("outcome").hidden = false;
  document.getElementById("outcome").textContent = "This browser cannot show the game: " + error.message;
  throw error;
});
