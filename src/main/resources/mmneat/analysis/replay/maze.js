/* The maze, the characters and the trail. */
const GHOST_COLOURS = ["#ff4b4b", "#ff9ad5", "#3fe0ff", "#ffa94d"];
const VIEW = { left: -5, top: -2, width: 118, height: 124 };
const ARROW = [[0, -1], [1, 0], [0, 1], [-1, 0], [0, 0]];

class MazeView {
  constructor(recording, canvas) {
    this.recording = recording;
    this.canvas = canvas;
    this.walls = document.createElement("canvas");
    this.trail = document.createElement("canvas");
    this.trailShown = true;
    this.trailStep = -1;
    this.deaths = new Set(recording.deaths);
    this.reset();
  }

  reset() { this.wallsOf = null; this.trailStep = -1; }

  /** Draws the state between two steps: `at` is a step number with a fraction. */
  draw(at, clock) {
    const surface = sharp(this.canvas);
    if (!surface) return;
    const { context, width, height, ratio } = surface;
    const scale = Math.min(width / VIEW.width, height / VIEW.height);
    const key = `${this.canvas.width}x${this.canvas.height}`;
    if (key !== this.key) { this.key = key; this.reset(); }
    this.transform = [scale * ratio, 0, 0, scale * ratio,
      ((width - scale * VIEW.width) / 2 - VIEW.left * scale) * ratio, ((height - scale * VIEW.height) / 2 - VIEW.top * scale) * ratio];
    const step = Math.min(Math.floor(at), this.recording.steps - 1), fraction = at - step;
    const chapter = chapterAt(this.recording, step), maze = this.recording.mazeOf[chapter.maze];
    this.drawWalls(maze);
    this.drawTrail(maze, chapter, step);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.walls, 0, 0);
    if (this.trailShown) {
      context.globalAlpha = .78;
      context.drawImage(this.trail, 0, 0);
      context.globalAlpha = 1;
    }
    context.setTransform(...this.transform);
    this.drawPills(context, maze, chapter, step, clock);
    for (let ghost = 3; ghost >= 0; ghost--) this.drawGhost(context, maze, ghost, step, fraction, clock);
    this.drawPacMan(context, maze, step, fraction);
  }

  drawWalls(maze) {
    if (this.wallsOf === maze) return;
    this.wallsOf = maze;
    const walls = this.walls;
    walls.width = this.canvas.width; walls.height = this.canvas.height;
    const c = walls.getContext("2d");
    c.setTransform(...this.transform);
    c.fillStyle = "#0a1030";
    c.fillRect(VIEW.left - 50, VIEW.top - 50, VIEW.width + 100, VIEW.height + 100);
    const corridors = new Path2D();
    for (let node = 0; node < maze.x.length; node++) {
      for (const next of [maze.right[node], maze.down[node]]) {
        if (next < 0) continue;
        if (Math.abs(maze.x[next] - maze.x[node]) + Math.abs(maze.y[next] - maze.y[node]) > 8) {
          // A tunnel: both ends are drawn beyond the border of the picture.
          for (const end of [node, next]) {
            corridors.moveTo(maze.x[end], maze.y[end]);
            corridors.lineTo(maze.x[end] + (maze.x[end] < 54 ? -10 : 10), maze.y[end]);
          }
        } else {
          corridors.moveTo(maze.x[node], maze.y[node]);
          corridors.lineTo(maze.x[next], maze.y[next]);
        }
      }
    }
    c.lineCap = "round"; c.lineJoin = "round";
    c.shadowColor = "#2f5bff"; c.shadowBlur = 5;
    c.strokeStyle = "#3557d6"; c.lineWidth = 8.6; c.stroke(corridors);
    c.shadowBlur = 0;
    c.strokeStyle = "#04060d"; c.lineWidth = 7.4; c.stroke(corridors);
    if (maze.lair >= 0) {
      const [x, y] = lairPlace(maze);
      c.strokeStyle = "#3557d6"; c.lineWidth = .6; c.fillStyle = "#04060d";
      c.beginPath(); c.roundRect(x - 13, y - 6, 26, 12, 1.5); c.fill(); c.stroke();
    }
  }

  drawTrail(maze, chapter, step) {
    const c = this.trail.getContext("2d");
    if (this.trailStep < chapter.step || this.trailStep > step) {
      this.trail.width = this.canvas.width; this.trail.height = this.canvas.height;
      this.trailStep = chapter.step;
    }
    c.setTransform(...this.transform);
    c.lineCap = "round"; c.lineWidth = 2.2;
    const { node, module } = this.recording.column;
    for (; this.trailStep < step; this.trailStep++) {
      if (this.deaths.has(this.trailStep)) c.clearRect(VIEW.left - 50, VIEW.top - 50, VIEW.width + 100, VIEW.height + 100);
      const from = node[this.trailStep], to = node[this.trailStep + 1];
      if (Math.abs(maze.x[from] - maze.x[to]) + Math.abs(maze.y[from] - maze.y[to]) > 2) continue;
      c.strokeStyle = moduleColour(module[this.trailStep]);
      c.beginPath(); c.moveTo(maze.x[from], maze.y[from]); c.lineTo(maze.x[to], maze.y[to]); c.stroke();
    }
  }

  drawPills(c, maze, chapter, step, clock) {
    const { pills, powerPills } = pillsAt(this.recording, chapter, step);
    c.fillStyle = "#ffe3c2";
    c.beginPath();
    for (const node of pills) { c.moveTo(maze.x[node] + .75, maze.y[node]); c.arc(maze.x[node], maze.y[node], .75, 0, 7); }
    c.fill();
    c.beginPath();
    const radius = 2 + .35 * Math.sin(clock / 160);
    for (const node of powerPills) { c.moveTo(maze.x[node] + radius, maze.y[node]); c.arc(maze.x[node], maze.y[node], radius, 0, 7); }
    c.fill();
  }

  place(maze, nodes, step, fraction) {
    const node = nodes[step], x = maze.x[node], y = maze.y[node];
    if (fraction > 0 && step + 1 < this.recording.steps) {
      const next = nodes[step + 1], dx = maze.x[next] - x, dy = maze.y[next] - y;
      if (Math.abs(dx) + Math.abs(dy) <= 2) return [x + dx * fraction, y + dy * fraction];
    }
    return [x, y];
  }

  drawPacMan(c, maze, step, fraction) {
    const { node, move, choice } = this.recording.column;
    const [x, y] = this.place(maze, node, step, fraction);
    const heading = choice[step] < 4 ? choice[step] : move[step];
    const angle = [-Math.PI / 2, 0, Math.PI / 2, Math.PI, 0][heading];
    const gape = .08 + .62 * Math.abs(Math.sin((step + fraction) * .35));
    c.save();
    c.translate(x, y); c.rotate(angle);
    c.shadowColor = "#ffd84a"; c.shadowBlur = 14;
    c.fillStyle = "#ffd84a";
    c.beginPath(); c.moveTo(-.4, 0); c.arc(0, 0, 3.5, gape, 2 * Math.PI - gape); c.closePath(); c.fill();
    c.restore();
  }

  drawGhost(c, maze, ghost, step, fraction, clock) {
    const column = this.recording.column;
    const inLair = column["lair" + ghost][step] > 0;
    const edible = column["edible" + ghost][step];
    let [x, y] = this.place(maze, column["ghostNode" + ghost], step, fraction);
    if (maze.lair >= 0 && column["ghostNode" + ghost][step] === maze.lair) {
      [x, y] = lairPlace(maze);
      x += (ghost - 1.5) * 6.2;
    }
    const ending = edible > 0 && edible < 40 && Math.floor(clock / 180) % 2 === 0;
    c.globalAlpha = inLair ? .6 : 1;
    c.fillStyle = edible > 0 ? (ending ? "#f4f6ff" : "#3d5bff") : GHOST_COLOURS[ghost];
    c.beginPath();
    c.arc(x, y - .2, 3.1, Math.PI, 0);
    c.lineTo(x + 3.1, y + 3);
    for (let k = 0; k < 3; k++) c.quadraticCurveTo(x + 2.6 - 2.07 * k, y + 1.7, x + 1.03 - 2.07 * k, y + 3);
    c.closePath(); c.fill();
    const [dx, dy] = ARROW[column["ghostMove" + ghost][step]];
    c.fillStyle = ending ? "#d63b3b" : "#fff";
    for (const side of [-1.2, 1.2]) { c.beginPath(); c.ellipse(x + side + dx * .35, y - .5 + dy * .35, .85, 1.05, 0, 0, 7); c.fill(); }
    if (edible === 0) {
      c.fillStyle = "#14205c";
      for (const side of [-1.2, 1.2]) { c.beginPath(); c.arc(x + side + dx * .8, y - .5 + dy * .9, .5, 0, 7); c.fill(); }
    }
    c.globalAlpha = 1;
  }
}

/** The middle of the lair. The mazes are symmetric, but the lair's node is slightly off the middle. */
function lairPlace(maze) { return [(Math.min(...maze.x) + Math.max(...maze.x)) / 2, maze.y[maze.lair]]; }

/** The chapter (a maze of a game) that a step belongs to. */
function chapterAt(recording, step) {
  let found = recording.chapters[0];
  for (const chapter of recording.chapters) if (chapter.step <= step) found = chapter;
  return found;
}

/** Nodes of the pills and power pills that remain at a step. */
function pillsAt(recording, chapter, step) {
  if (recording.pillsAtStep === step) return recording.pillsLeft;
  const maze = recording.mazeOf[chapter.maze], { eaten, node } = recording.column;
  const pills = new Set(chapter.pills.map(i => maze.pills[i])), powerPills = new Set(chapter.powerPills.map(i => maze.powerPills[i]));
  for (let i = chapter.step; i <= step; i++) {
    if (eaten[i] & 1) pills.delete(node[i]);
    if (eaten[i] & 2) powerPills.delete(node[i]);
  }
  recording.pillsAtStep = step;
  return recording.pillsLeft = { pills, powerPills };
}
