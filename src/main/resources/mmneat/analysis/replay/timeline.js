/** Height of the names below the strip, in CSS pixels. */
const NAMES_HEIGHT = 16;

/* The time line: deciding module, edible ghosts and score over the whole game. Dragging in it moves the position. */
class Timeline {
  constructor(recording, canvas) {
    this.recording = recording;
    this.canvas = canvas;
    this.picture = document.createElement("canvas");
  }

  draw(at) {
    const surface = sharp(this.canvas);
    if (!surface) return;
    const { context: c, width, height, ratio } = surface;
    const key = `${this.canvas.width}x${this.canvas.height}`;
    if (key !== this.key) { this.key = key; this.paint(width, height, ratio); }
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.drawImage(this.picture, 0, 0);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    const x = this.x(at, width);
    c.fillStyle = "#04060daa"; c.fillRect(x, 0, width - x, height - NAMES_HEIGHT);
    c.fillStyle = "#fff"; c.fillRect(x - 1, 0, 2, height);
    c.beginPath(); c.arc(x, height / 2, 6, 0, 7); c.fill();
  }

  x(step, width) { return 8 + (width - 16) * step / Math.max(1, this.recording.steps - 1); }

  step(x, width) {
    const share = Math.max(0, Math.min(1, (x - 8) / (width - 16)));
    return Math.round(share * (this.recording.steps - 1));
  }

  paint(width, height, ratio) {
    const { recording, picture } = this, { steps, column } = recording;
    picture.width = this.canvas.width; picture.height = this.canvas.height;
    const c = picture.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = "#0e1428"; c.fillRect(0, 0, width, height);
    const band = height - NAMES_HEIGHT;
    for (let px = 8; px < width - 8; px++) {
      const from = this.step(px, width), to = Math.max(from + 1, this.step(px + 1, width));
      const votes = new Map();
      let edible = false;
      for (let i = from; i < to && i < steps; i++) {
        if (column.module[i] !== WALL) votes.set(column.module[i], (votes.get(column.module[i]) || 0) + 1);
        for (let g = 0; g < 4; g++) edible ||= column["edible" + g][i] > 0;
      }
      const most = [...votes].sort((a, b) => b[1] - a[1])[0];
      if (most) { c.fillStyle = moduleColour(most[0]); c.globalAlpha = .85; c.fillRect(px, 0, 1, band - 5); c.globalAlpha = 1; }
      if (edible) { c.fillStyle = "#7f9bff"; c.fillRect(px, band - 4, 1, 4); }
    }
    this.paintScore(c, width, band - 7);
    for (const death of recording.deaths) this.cross(c, this.x(death, width), 8);
    this.paintNames(c, width, height);
  }

  /** Marks a lost life. */
  cross(c, x, y) {
    for (const [colour, line] of [["#04060d", 5], ["#ff6048", 2.2]]) {
      c.strokeStyle = colour; c.lineWidth = line; c.lineCap = "round";
      c.beginPath(); c.moveTo(x - 4, y - 4); c.lineTo(x + 4, y + 4); c.moveTo(x + 4, y - 4); c.lineTo(x - 4, y + 4); c.stroke();
    }
  }

  /** Writes below each part the longest of its names that fits. */
  paintNames(c, width, height) {
    const { chapters } = this.recording;
    c.font = "11px system-ui, sans-serif"; c.textBaseline = "middle"; c.textAlign = "left"; c.fillStyle = "#aab3d6";
    chapters.forEach((chapter, i) => {
      const x = this.x(chapter.step, width), end = i + 1 < chapters.length ? this.x(chapters[i + 1].step, width) : width;
      const firstOfGame = i === 0 || chapters[i - 1].game !== chapter.game;
      if (i > 0) { c.fillStyle = "#090c16"; c.fillRect(x - (firstOfGame ? 2 : 1), 0, firstOfGame ? 4 : 2, height); c.fillStyle = "#aab3d6"; }
      const letter = mazeLetter(chapter), maze = "Maze " + letter;
      const names = chapter.game && firstOfGame ? [`${chapter.game} · ${maze}`, `${chapter.game} · ${letter}`, letter] : [maze, letter];
      const name = names.find(text => c.measureText(text).width <= end - x - 6);
      if (name) c.fillText(name, x + 4, height - 7);
    });
  }

  paintScore(c, width, height) {
    const { steps, column } = this.recording, top = column.score.reduce((most, score) => Math.max(most, score), 1);
    c.beginPath();
    for (let px = 8; px <= width - 8; px++) {
      const y = height - (height - 3) * column.score[Math.min(steps - 1, this.step(px, width))] / top;
      if (px === 8) c.moveTo(px, y); else c.lineTo(px, y);
    }
    c.strokeStyle = "#04060d"; c.lineWidth = 3.5; c.stroke();
    c.strokeStyle = "#fff"; c.lineWidth = 1.6; c.stroke();
  }
}

const mazeLetter = chapter => String.fromCharCode(65 + chapter.maze);

function chapterName(chapter) {
  const maze = "Maze " + mazeLetter(chapter);
  return chapter.game ? `${chapter.game} · ${maze}` : maze;
}
