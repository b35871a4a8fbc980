// SPDX-License-Identifier: Apache-2.0
// Replays a plan ("motion") and the search that found it ("search") on one canvas. The data's form is in page.cpp.
'use strict';
(() => {
  const byId = (id) => document.getElementById(id);

  // ---- data: metres, radians, seconds
  const raw = JSON.parse(byId('data').textContent);
  const decode = (text, Type) => new Type(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

  const rings = ({sizes, points}) => {
    const xy = decode(points, Int32Array);
    let at = 0;
    return Array.from(decode(sizes, Uint32Array), (size) => {
      const ring = Array.from(xy.subarray(at, at + 2 * size), (mm) => mm / 1000);
      at += 2 * size;
      return ring;
    });
  };
  const metres = (text) => Float64Array.from(decode(text, Int32Array), (mm) => mm / 1000);

  const [minX, minY, maxX, maxY] = raw.bounds;
  const obstacles = rings(raw.obstacles);
  const goal = rings(raw.goal)[0];
  const arrows = rings(raw.arrows);
  const bodies = rings(raw.bodies);
  const front = rings(raw.front)[0];
  const bodySize = Math.max(0, ...bodies.flat().map(Math.abs));  // metres, from a body's axle to its farthest side
  const triangles = metres(raw.triangles);
  const triangleCount = triangles.length / 6;
  const frames = {iterations: raw.frames.iterations, top: raw.frames.top, levels: decode(raw.frames.levels, Uint8Array)};
  const tree = {
    points: metres(raw.tree.points),
    parents: decode(raw.tree.parents, Uint32Array),
    iterations: decode(raw.tree.iterations, Uint32Array),
  };
  const motion = {
    times: decode(raw.motion.times, Float32Array),
    states: decode(raw.motion.states, Float32Array),
    points: metres(raw.motion.points),
    headings: Float64Array.from(decode(raw.motion.headings, Int16Array), (units) => units * Math.PI / 32768),
  };
  const start = {
    points: metres(raw.start.points),
    headings: Float64Array.from(decode(raw.start.headings, Int16Array), (units) => units * Math.PI / 32768),
  };
  const marks = metres(raw.marks);
  const samples = motion.times.length;
  const stateSize = samples ? motion.states.length / samples : 0;
  const names = Array.from({length: stateSize}, (_, i) => raw.names[i] ?? `state[${i}]`);
  const ramp = decode(raw.ramp, Uint8Array);
  const infinite = ramp.length / 3 - 1;
  const rampColor = (level) => `rgb(${ramp[3 * level]} ${ramp[3 * level + 1]} ${ramp[3 * level + 2]})`;

  // ---- state; window.krait shows it to tests
  const ends = {
    motion: samples ? motion.times[samples - 1] : 0,
    search: Math.max(frames.iterations.at(-1) ?? 0, tree.iterations.at(-1) ?? 0),
  };
  const searchSeconds = 12;  // how long the whole search plays at speed 1
  const position = {motion: 0, search: 0};
  const layers = {triangles: true, raised: false, tree: true, path: true, bodies: true};
  const view = {x: 0, y: 0, scale: 1};  // the middle in metres, pixels a metre
  let mode = samples || !ends.search ? 'motion' : 'search';
  let playing = false;
  let speed = 1;
  let fitted = true;
  let drawn = 0;

  const canvas = byId('map');
  const context = canvas.getContext('2d');
  const size = {width: 1, height: 1};

  // The number of entries of an ascending list that are at most a value.
  const countUpTo = (list, value) => {
    let low = 0;
    let high = list.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (list[middle] <= value) low = middle + 1; else high = middle;
    }
    return low;
  };
  const wrap = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
  const mix = (a, b, share) => a + (b - a) * share;

  const currentFrame = () => frames.iterations.length === 0 ? -1 :
      mode === 'motion' ? frames.iterations.length - 1 :
      Math.max(0, countUpTo(frames.iterations, position.search) - 1);
  // Costs are shown as they were before the search; as failures have raised them only where that is asked for.
  const shownFrame = () => layers.raised ? currentFrame() : Math.min(0, currentFrame());
  const currentVertices = () => mode === 'motion' ? tree.parents.length : countUpTo(tree.iterations, position.search);
  const searchEnded = () => mode === 'motion' || position.search >= ends.search;

  // The sample at or before a time and the share of the way to the next.
  const sampleAt = (time) => {
    const index = Math.max(0, Math.min(countUpTo(motion.times, time) - 1, samples - 2));
    const from = motion.times[index];
    const to = motion.times[Math.min(index + 1, samples - 1)];
    return {index, next: Math.min(index + 1, samples - 1), share: to > from ? Math.min(1, (time - from) / (to - from)) : 0};
  };
  const posesAt = (time) => {
    const {index, next, share} = sampleAt(time);
    return bodies.map((_, k) => {
      const a = index * bodies.length + k;
      const b = next * bodies.length + k;
      return {
        x: mix(motion.points[2 * a], motion.points[2 * b], share),
        y: mix(motion.points[2 * a + 1], motion.points[2 * b + 1], share),
        heading: motion.headings[a] + wrap(motion.headings[b] - motion.headings[a]) * share,
      };
    });
  };
  // The stored state nearest in time.
  const stateAt = (time) => {
    const {index, next, share} = sampleAt(time);
    const at = (share > 0.5 ? next : index) * stateSize;
    return motion.states.subarray(at, at + stateSize);
  };

  // ---- drawing
  let colors = {};
  const readColors = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['panel', 'ink', 'free', 'obstacle', 'mesh', 'tree', 'veil', 'casing', 'travelled', 'goal', 'start',
      'robot', 'trailer']) {
      colors[name] = style.getPropertyValue(`--${name}`).trim();
    }
  };

  const pixels = (count) => count / view.scale;  // a length on the screen, in metres
  const tracePolygon = (target, ring) => {
    for (let i = 0; i < ring.length; i += 2) {
      if (i === 0) target.moveTo(ring[0], ring[1]); else target.lineTo(ring[i], ring[i + 1]);
    }
    target.closePath();
  };
  const toScene = (target) => {
    const ratio = target.canvas.width / size.width;
    const scale = view.scale * ratio;
    target.setTransform(scale, 0, 0, -scale, target.canvas.width / 2 - view.x * scale,
        target.canvas.height / 2 + view.y * scale);
    target.lineJoin = 'round';
    target.lineCap = 'round';
  };

  const drawTriangles = (target, frame) => {
    const byLevel = new Map();
    const base = frame * triangleCount;
    for (let i = 0; i < triangleCount; ++i) {
      const level = frames.levels[base + i];
      if (!byLevel.has(level)) byLevel.set(level, []);
      byLevel.get(level).push(i);
    }
    target.lineWidth = pixels(0.8);  // closes the seams between neighbours
    for (const [level, members] of byLevel) {
      target.beginPath();
      for (const i of members) tracePolygon(target, triangles.subarray(6 * i, 6 * i + 6));
      target.fillStyle = target.strokeStyle = rampColor(level);
      target.fill();
      target.stroke();
    }
  };
  const drawMesh = (target) => {
    target.beginPath();
    for (let i = 0; i < triangleCount; ++i) tracePolygon(target, triangles.subarray(6 * i, 6 * i + 6));
    target.strokeStyle = colors.mesh;
    target.lineWidth = pixels(0.6);
    target.stroke();
  };
  const drawTree = (target, count) => {
    target.beginPath();
    for (let i = 0; i < count; ++i) {
      const parent = tree.parents[i];
      target.moveTo(tree.points[2 * parent], tree.points[2 * parent + 1]);
      target.lineTo(tree.points[2 * i], tree.points[2 * i + 1]);
    }
    target.strokeStyle = colors.tree;
    target.lineWidth = pixels(0.7);
    target.stroke();
  };

  // What does not move is kept in a canvas of its own and drawn again only when its key changes.
  const still = document.createElement('canvas').getContext('2d');
  let stillKey = '';
  const drawStill = (frame, vertices) => {
    const key = [canvas.width, canvas.height, view.x, view.y, view.scale, frame, vertices, layers.triangles, layers.raised,
      layers.tree,
      colors.panel].join();
    if (key === stillKey) return;
    stillKey = key;
    still.canvas.width = canvas.width;
    still.canvas.height = canvas.height;
    toScene(still);
    still.save();
    still.beginPath();
    still.rect(minX, minY, maxX - minX, maxY - minY);
    still.fillStyle = colors.free;
    still.fill();
    still.clip();
    if (layers.triangles || layers.raised) {
      if (frame >= 0) drawTriangles(still, frame);
      drawMesh(still);
      still.fillStyle = colors.veil;
      still.fillRect(minX, minY, maxX - minX, maxY - minY);
    }
    still.beginPath();
    for (const ring of obstacles) tracePolygon(still, ring);
    still.fillStyle = still.strokeStyle = colors.obstacle;
    still.lineWidth = pixels(0.6);
    still.fill();
    still.stroke();
    if (goal.length) {
      still.beginPath();
      tracePolygon(still, goal);
      still.fillStyle = colors.goal;
      still.strokeStyle = '#171b22';
      still.lineWidth = pixels(2);
      still.fill();
      still.stroke();
    }
    for (const arrow of arrows) {
      still.beginPath();
      for (let i = 0; i < arrow.length; i += 2) still.lineTo(arrow[i], arrow[i + 1]);
      still.strokeStyle = '#171b22';
      still.stroke();
    }
    if (layers.tree) drawTree(still, vertices);
    still.restore();
    still.strokeStyle = colors.ink;
    still.lineWidth = pixels(1.2);
    still.strokeRect(minX, minY, maxX - minX, maxY - minY);
  };

  const tracePath = (until) => {
    context.beginPath();
    const stride = 2 * bodies.length;
    for (let i = 0; i <= until; ++i) context.lineTo(motion.points[i * stride], motion.points[i * stride + 1]);
  };
  const strokePath = (width, color) => {
    context.lineWidth = pixels(width);
    context.strokeStyle = color;
    context.stroke();
  };
  const drawPath = () => {
    tracePath(samples - 1);
    strokePath(4.5, colors.casing);
    strokePath(1.8, colors.travelled);
    if (mode !== 'motion' || position.motion === 0) return;
    const {index} = sampleAt(position.motion);
    const head = posesAt(position.motion)[0];
    tracePath(index);
    context.lineTo(head.x, head.y);
    strokePath(4.5, colors.casing);
    strokePath(3, colors.robot);
  };
  const startPoses = () => Array.from(start.headings,
      (heading, k) => ({x: start.points[2 * k], y: start.points[2 * k + 1], heading}));
  // Of points in the frame of a body.
  const placed = (pose, points) => {
    const c = Math.cos(pose.heading);
    const s = Math.sin(pose.heading);
    return points.map((_, i) => i % 2 === 0 ? pose.x + c * points[i] - s * points[i + 1] :
        pose.y + s * points[i - 1] + c * points[i]);
  };
  const drawFront = (pose, width) => {
    const mark = placed(pose, front);
    context.beginPath();
    for (let i = 0; i < mark.length; i += 2) context.lineTo(mark[i], mark[i + 1]);
    strokePath(width, colors.casing);
  };
  const drawRobot = (poses) => {
    const outline = Math.min(1.4, 0.2 * bodySize * view.scale);
    for (let k = poses.length - 1; k >= 0; --k) {
      context.beginPath();
      tracePolygon(context, placed(poses[k], bodies[k]));
      context.fillStyle = k === 0 ? colors.robot : colors.trailer;
      context.fill();
      strokePath(outline, colors.casing);
    }
    if (poses.length > 0) drawFront(poses[0], outline);
  };
  const drawStart = () => {
    const at = samples ? motion.points : tree.points;
    if (at.length === 0) return;
    context.beginPath();
    context.arc(at[0], at[1], pixels(6), 0, 2 * Math.PI);
    context.fillStyle = colors.start;
    context.fill();
    strokePath(2, '#171b22');
    drawLabel('start', at[0], at[1]);
  };
  // Where there is no plan for what reason, numbered as in the line of facts.
  const drawMarks = () => {
    const ratio = canvas.width / size.width;
    context.save();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.font = '600 11px system-ui, "DejaVu Sans", sans-serif';
    context.textAlign = 'center';
    for (let i = 0; 2 * i < marks.length; ++i) {
      const x = (marks[2 * i] - view.x) * view.scale + size.width / 2;
      const y = size.height / 2 - (marks[2 * i + 1] - view.y) * view.scale;
      context.beginPath();
      context.arc(x, y, 8, 0, 2 * Math.PI);
      context.fillStyle = '#171b22';
      context.fill();
      context.lineWidth = 1.5;
      context.strokeStyle = '#ffffff';
      context.stroke();
      context.fillStyle = '#ffffff';
      context.fillText(String(i + 1), x, y + 4);
    }
    context.restore();
  };
  const drawLabel = (text, x, y) => {
    const ratio = canvas.width / size.width;
    context.save();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.font = '600 13px system-ui, "DejaVu Sans", sans-serif';
    context.lineJoin = 'round';
    const mark = (x - view.x) * view.scale + size.width / 2;
    const width = context.measureText(text).width;
    const left = mark + 10 + width > size.width - 4 ? mark - 10 - width : mark + 10;
    const base = size.height / 2 - (y - view.y) * view.scale - 8;
    context.lineWidth = 4;
    context.strokeStyle = 'rgb(255 255 255 / 90%)';
    context.strokeText(text, left, base);
    context.fillStyle = '#171b22';
    context.fillText(text, left, base);
    context.restore();
  };
  const drawGoalLabel = () => {
    if (goal.length === 0) return;
    let top = 0;
    for (let i = 2; i < goal.length; i += 2) {
      if (goal[i + 1] > goal[top + 1] || (goal[i + 1] === goal[top + 1] && goal[i] > goal[top])) top = i;
    }
    drawLabel('goal', goal[top], goal[top + 1]);
  };

  const draw = () => {
    drawStill(shownFrame(), currentVertices());
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = colors.panel;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(still.canvas, 0, 0);
    toScene(context);
    if (samples && layers.path && searchEnded()) drawPath();
    if (samples && layers.bodies && mode === 'motion') drawRobot(posesAt(position.motion));
    if (!samples && layers.bodies) drawRobot(startPoses());
    drawStart();
    drawGoalLabel();
    drawMarks();
    ++drawn;
  };

  // ---- read-outs
  const number = (value, digits) => value.toFixed(digits).replace(/^-(0(\.0*)?)$/, '$1').replace('-', '−');
  const degrees = (angle) => `${number(wrap(angle) * 180 / Math.PI, 0)}°`;
  const setList = (list, rows) => {
    if (list.children.length !== 2 * rows.length) {
      list.replaceChildren(...rows.flatMap(() => [document.createElement('dt'), document.createElement('dd')]));
    }
    rows.forEach(([name, value], i) => {
      list.children[2 * i].textContent = name;
      list.children[2 * i + 1].textContent = value;
    });
  };
  const rates = (time) => {
    const {index, next} = sampleAt(time);
    const dt = motion.times[next] - motion.times[index] || 1;
    const a = index * bodies.length;
    const b = next * bodies.length;
    return {
      speed: Math.hypot(motion.points[2 * b] - motion.points[2 * a], motion.points[2 * b + 1] - motion.points[2 * a + 1]) / dt,
      turn: wrap(motion.headings[b] - motion.headings[a]) / dt,
    };
  };
  const motionRows = () => {
    if (!samples) return [['plan', 'none']];
    const time = position.motion;
    const state = stateAt(time);
    const head = posesAt(time)[0];
    const value = (name) => state[names.indexOf(name)];
    const {speed: pace, turn} = rates(time);
    return [
      ['time', `${number(time, 1)} s`],
      ['speed', `${number(value('v') ?? pace, 2)} m/s`],
      value('psi') === undefined ? ['turn rate', `${number(turn * 180 / Math.PI, 0)}°/s`] : ['steering', degrees(value('psi'))],
      ['x', `${number(head.x + raw.origin[0], 2)} m`],
      ['y', `${number(head.y + raw.origin[1], 2)} m`],
      ['heading', degrees(head.heading)],
    ];
  };
  const searchRows = () => {
    const rows = [
      ['iteration', `${Math.floor(position.search)}`],
      ['tree vertices', `${currentVertices()} of ${tree.parents.length}`],
    ];
    const frame = shownFrame();
    if (frame >= 0) rows.push(['costs as of', `${frames.iterations[frame]}`]);
    return rows;
  };
  const positionText = () => mode === 'motion' ? `${number(position.motion, 1)} / ${number(ends.motion, 1)} s` :
      `${Math.floor(position.search)} / ${ends.search}`;

  const roundLength = (limit) => {
    const power = 10 ** Math.floor(Math.log10(limit));
    return [5, 2, 1].map((factor) => factor * power).find((length) => length <= limit * 1.0001) ?? power;
  };
  const showScale = () => {
    const length = roundLength(130 / view.scale);
    byId('scale').style.width = `${length * view.scale}px`;
    byId('scale').firstElementChild.textContent = `${Number(length.toPrecision(3))} m`;
  };
  const showCosts = () => {
    const frame = shownFrame();
    byId('costs').hidden = frame < 0;
    if (frame < 0) return;
    byId('top').textContent = `${number(frames.top, 0)} m`;
    const levels = frames.levels.subarray(frame * triangleCount, (frame + 1) * triangleCount);
    byId('cut-off').hidden = !levels.includes(infinite);
  };

  const show = () => {
    draw();
    const scrub = byId('scrub');
    scrub.max = ends[mode] || 1;
    scrub.value = position[mode];
    scrub.disabled = byId('play').disabled = !ends[mode];
    scrub.setAttribute('aria-valuetext', mode === 'motion' ? `${number(position.motion, 1)} seconds` :
      `iteration ${Math.floor(position.search)}`);
    byId('position').textContent = positionText();
    byId('mode').value = mode;
    byId('play').classList.toggle('playing', playing);
    byId('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
    setList(byId('readings'), mode === 'motion' ? motionRows() : searchRows());
    byId('state').hidden = mode !== 'motion' || !samples;
    if (byId('state').open && samples) {
      const state = stateAt(position.motion);
      setList(byId('state').querySelector('dl'), names.map((name, i) => [name, number(state[i], 3)]));
    }
    showScale();
    showCosts();
  };
  let requested = false;
  const request = () => {
    if (requested) return;
    requested = true;
    requestAnimationFrame(() => { requested = false; show(); });
  };

  // ---- time
  let before = 0;
  const tick = (now) => {
    if (!playing) return;
    const seconds = Math.min(0.25, (now - before) / 1000) * speed;
    before = now;
    position[mode] += mode === 'motion' ? seconds : seconds * ends.search / searchSeconds;
    if (position[mode] >= ends[mode]) {
      position[mode] = ends[mode];
      playing = false;
    }
    show();
    requestAnimationFrame(tick);
  };
  const setPlaying = (on) => {
    if (playing === on || !ends[mode]) return;
    playing = on;
    if (on && position[mode] >= ends[mode]) position[mode] = 0;
    before = performance.now();
    if (on) requestAnimationFrame(tick);
    request();
  };
  const seek = (value) => {
    position[mode] = Math.min(ends[mode], Math.max(0, value));
    request();
  };
  const setMode = (name) => {
    if (!ends[name]) return;
    mode = name;
    playing = false;
    request();
  };

  // ---- view
  const fitView = () => {
    const margin = 18;
    view.x = (minX + maxX) / 2;
    view.y = (minY + maxY) / 2;
    view.scale = Math.min(Math.max(40, size.width - 2 * margin) / (maxX - minX),
        Math.max(40, size.height - 2 * margin) / (maxY - minY));
    fitted = true;
  };
  const fit = () => { fitView(); request(); };
  // Zooms so that the point of the map below (x, y), pixels from the middle of the canvas, stays there.
  const zoom = (factor, x = 0, y = 0) => {
    const least = 0.2 * Math.min(size.width / (maxX - minX), size.height / (maxY - minY));
    const scale = Math.min(20000, Math.max(least, view.scale * factor));
    view.x += x / view.scale - x / scale;
    view.y -= y / view.scale - y / scale;
    view.scale = scale;
    fitted = false;
    request();
  };
  const pan = (dx, dy) => {
    view.x = Math.min(maxX, Math.max(minX, view.x - dx / view.scale));
    view.y = Math.min(maxY, Math.max(minY, view.y + dy / view.scale));
    fitted = false;
    request();
  };
  const fromMiddle = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
  };
  const resize = () => {
    const box = canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    size.width = Math.max(1, box.width);
    size.height = Math.max(1, box.height);
    canvas.width = Math.round(size.width * ratio);
    canvas.height = Math.round(size.height * ratio);
    if (fitted) fitView();
    show();  // a canvas is empty after its size was set, and would be until the next frame
  };

  // ---- controls
  byId('play').addEventListener('click', () => setPlaying(!playing));
  byId('scrub').addEventListener('input', (event) => seek(Number(event.target.value)));
  byId('mode').addEventListener('change', (event) => setMode(event.target.value));
  byId('speed').addEventListener('change', (event) => { speed = Number(event.target.value); });
  byId('zoom-in').addEventListener('click', () => zoom(1.5));
  byId('zoom-out').addEventListener('click', () => zoom(1 / 1.5));
  byId('fit').addEventListener('click', fit);
  byId('state').addEventListener('toggle', request);
  for (const name of Object.keys(layers)) {
    byId(`layer-${name}`).addEventListener('change', (event) => {
      layers[name] = event.target.checked;
      request();
    });
  }

  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    zoom(Math.exp(-Math.max(-300, Math.min(300, event.deltaY * lines)) / 500), ...fromMiddle(event));
  }, {passive: false});

  // One pointer drags; two pinch.
  const pointers = new Map();
  const spread = () => {
    const [a, b] = pointers.values();
    return Math.hypot(a[0] - b[0], a[1] - b[1]) || 1;
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, fromMiddle(event));
  });
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const now = fromMiddle(event);
    const spreadBefore = pointers.size === 2 ? spread() : 0;
    pointers.set(event.pointerId, now);
    pan((now[0] - last[0]) / pointers.size, (now[1] - last[1]) / pointers.size);
    if (pointers.size === 2) zoom(spread() / spreadBefore, ...now);
  });
  for (const name of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(name, (event) => pointers.delete(event.pointerId));
  }

  const keys = {
    ' ': () => setPlaying(!playing),
    'ArrowLeft': () => seek(position[mode] - ends[mode] / 100),
    'ArrowRight': () => seek(position[mode] + ends[mode] / 100),
    'Home': () => seek(0),
    'End': () => seek(ends[mode]),
    'm': () => setMode(mode === 'motion' ? 'search' : 'motion'),
    '+': () => zoom(1.5),
    '=': () => zoom(1.5),
    '-': () => zoom(1 / 1.5),
    '0': fit,
  };
  const moves = {ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60]};
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest('select') || (event.key === ' ' && event.target.closest('button, input, summary'))) return;
    if (event.target === byId('scrub') && /^(Arrow|Home|End)/.test(event.key)) return;
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.shiftKey && moves[name]) pan(...moves[name]);
    else if (keys[name]) keys[name]();
    else return;
    event.preventDefault();
  });

  // ---- begin
  const stops = Array.from({length: 11}, (_, i) => rampColor(Math.round(i * (infinite - 1) / 10))).join(', ');
  for (const bar of document.querySelectorAll('.ramp')) bar.style.background = `linear-gradient(90deg, ${stops})`;
  if (!ends.motion) byId('mode').querySelector('[value=motion]').disabled = true;
  if (!ends.search) byId('mode').querySelector('[value=search]').disabled = true;
  readColors();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { readColors(); request(); });
  new ResizeObserver(resize).observe(canvas);  // calls resize before the first frame is painted

  window.krait = {
    get mode() { return mode; },
    get playing() { return playing; },
    get speed() { return speed; },
    get time() { return position.motion; },
    get duration() { return ends.motion; },
    get iteration() { return position.search; },
    get iterations() { return ends.search; },
    get vertices() { return currentVertices(); },
    get frame() { return shownFrame(); },
    get view() { return {...view}; },
    get drawn() { return drawn; },
    get layers() { return {...layers}; },
  };
})();
