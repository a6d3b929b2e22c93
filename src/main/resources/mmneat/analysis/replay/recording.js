/* The recording: columns of differences, packed with zlib; see ReplayRecorder. Gives one typed array per quantity. */
const UP = 0, RIGHT = 1, DOWN = 2, LEFT = 3, WALL = 255;

async function unpack(base64) {
  const packed = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function addUp(bytes, offset, width, count) {
  const values = width === 1 ? new Uint8Array(count) : width === 2 ? new Uint16Array(count) : new Uint32Array(count);
  const mask = 2 ** (8 * width) - 1;
  let value = 0;
  for (let i = 0; i < count; i++) {
    let difference = 0;
    for (let plane = 0; plane < width; plane++) difference |= bytes[offset + plane * count + i] << (8 * plane);
    value = (value + difference) & mask;
    values[i] = value;
  }
  return values;
}

async function readRecording(element) {
  const recording = JSON.parse(element.textContent);
  const bytes = await unpack(recording.data);
  delete recording.data;
  const steps = recording.steps, details = Math.ceil(steps / recording.detailEvery);
  const column = {};
  let offset = 0;
  for (const [name, width] of recording.columns) {
    const count = /^(sensor|node)\d_/.test(name) ? details : steps;
    column[name] = addUp(bytes, offset, width, count);
    offset += width * count;
  }
  recording.column = column;
  recording.mazeOf = Object.fromEntries(recording.mazes.map(maze => [maze.index, maze]));
  recording.ghostsEaten = countGhosts(recording);
  return recording;
}

/** Ghosts eaten up to each step, counted anew for each game of the recording. */
function countGhosts({ steps, column, chapters }) {
  const eaten = new Uint16Array(steps);
  const starts = new Set(chapters.filter((c, i) => i === 0 || c.game !== chapters[i - 1].game).map(c => c.step));
  for (let i = 1; i < steps; i++) {
    if (starts.has(i)) continue;
    eaten[i] = eaten[i - 1];
    for (let g = 0; g < 4; g++) {
      if (column["edible" + g][i - 1] > 0 && column["edible" + g][i] === 0 && column["lair" + g][i] > 0) eaten[i]++;
    }
  }
  return eaten;
}

/* One colour per module, told apart by colour-blind readers and, by brightness, in grey. */
const MODULE_COLOURS = ["#ffb000", "#5b8cff", "#e8327c", "#35d3b0", "#b48cff", "#ff7a2e", "#9fe84a", "#c9d2f0"];
const moduleColour = module => module === WALL ? "#6b7496" : MODULE_COLOURS[module % MODULE_COLOURS.length];

/** Makes a canvas as fine as the screen; returns its context in CSS pixels, or null while it is not shown. */
function sharp(canvas) {
  const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  if (!box.width || !box.height) return null;
  const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width: box.width, height: box.height, ratio };
}
