/* Unpacks the recording: columns of differences, compressed with zlib (see ReplayRecorder), to one array per quantity. */
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
  recording.gameStarts = gameStarts(recording);
  recording.total = addGames(recording);
  recording.deaths = findDeaths(recording);
  recording.events = listEvents(recording);
  return recording;
}

/** First step of each game of the recording. */
function gameStarts({ chapters }) {
  return chapters.filter((c, i) => i === 0 || c.game !== chapters[i - 1].game).map(c => c.step);
}

/** Ghosts eaten up to each step; the count restarts with each game of the recording. */
function countGhosts(recording) {
  const { steps, column } = recording, eaten = new Uint16Array(steps), starts = new Set(gameStarts(recording));
  for (let i = 1; i < steps; i++) {
    if (starts.has(i)) continue;
    eaten[i] = eaten[i - 1];
    for (let g = 0; g < 4; g++) {
      if (column["edible" + g][i - 1] > 0 && column["edible" + g][i] === 0 && column["lair" + g][i] > 0) eaten[i]++;
    }
  }
  return eaten;
}

/** Points up to each step, including those of earlier games. */
function addGames({ steps, column, gameStarts }) {
  const total = new Uint32Array(steps), starts = new Set(gameStarts);
  let before = 0;
  for (let i = 0; i < steps; i++) {
    if (i > 0 && starts.has(i)) before += column.score[i - 1];
    total[i] = before + column.score[i];
  }
  return total;
}

/** Steps in which a life is lost and the game continues: the last step before Ms. Pac-Man starts again. */
function findDeaths({ steps, column, gameStarts }) {
  const starts = new Set(gameStarts), deaths = [];
  for (let i = 1; i < steps - 1; i++) if (!starts.has(i) && column.lives[i] < column.lives[i - 1] && !starts.has(i + 1)) deaths.push(i - 1);
  return deaths;
}

/** Events that the page announces, by step: ends of games and lost lives. */
function listEvents({ steps, column, deaths, outcomes, gameStarts, total }) {
  const games = gameStarts.length;
  const ends = outcomes.map(o => ({
    step: o.step,
    text: games > 1 && o.step === steps - 1 ? `${o.text} · ${total[o.step].toLocaleString("en")} in all ${games} games` : o.text,
  }));
  const lost = deaths.map(step => {
    const left = column.lives[step + 1];
    return { step, text: `Caught · ${left} ${left === 1 ? "life" : "lives"} left` };
  });
  return [...lost, ...ends].sort((a, b) => a.step - b.step);
}

const moduleColour = module => module === WALL ? "#6b7496" : MODULE_COLOURS[module % MODULE_COLOURS.length];

/** Sets a canvas to the screen's resolution. Returns its context, scaled to CSS pixels, or null while it is hidden. */
function sharp(canvas) {
  const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  if (!box.width || !box.height) return null;
  const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width: box.width, height: box.height, ratio };
}

const capital = text => text.charAt(0).toUpperCase() + text.slice(1);
