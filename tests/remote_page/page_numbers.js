// The greatest differences between the page's modules and numbers of the C++ code (page_reference.cpp). `all` is its JSON.
(async (all) => {
  const load = (name) => import(`/${name}.js`);
  const {GpcMap} = await load('gpc_map');
  const {Pinhole} = await load('view_math');
  const {ImageCover, coverLoad, plannedCover} = await load('image_cover');
  const {motionBetween, viewAhead} = await load('view_motion');
  const {LookPlanner} = await load('look_planner');
  const {smoothedLevels} = await load('depth_smoothing');
  const {decodedDepth} = await load('depth_codec');
  const worst = {};
  const compare = (name, a, b) => {
    const [p, q] = [[a].flat(), [b].flat()];
    p.forEach((value, i) => {
      const difference = value === q[i] ? 0 : Math.abs(value - q[i]);
      worst[name] = Math.max(worst[name] ?? 0, Number.isNaN(difference) ? Infinity : difference);
    });
  };
  for (const {layout, size, points} of all.maps) {
    const map = new GpcMap(layout, ...size);
    for (const {point, pinhole, image, rate} of points) {
      compare('pinholeFromImage', map.pinholeFromImage(point), pinhole);
      compare('imageFromPinhole', map.imageFromPinhole(point), image);
      compare('rate', map.rateAt(point), rate);
    }
    const places = map.places(...size);
    for (let x = 0; x < size[0]; x += 7) {
      const y = (5 * x) % size[1];
      const first = 2 * (y * size[0] + x);
      compare('places', [places[first], places[first + 1]], map.pinholeFromImage([x + 0.5, y + 0.5]));
    }
  }
  for (const {view, right, down, forward, focal, center} of all.views) {
    const pinhole = new Pinhole(view, 640, 360);
    compare('axes', [...pinhole.right, ...pinhole.down, ...pinhole.forward], [...right, ...down, ...forward]);
    compare('focal', pinhole.focal / focal, 1);
    compare('center', pinhole.center, center);
  }
  const {request, settings, planned, near, loads} = all.cover;
  const cover = new ImageCover(planned.view, ...planned.size, planned.layout, near);
  for (const {view, reach, detail, shift} of loads) {
    const load = coverLoad(cover, view, request.screen);
    compare('load', [load.reach / reach, load.detail / detail], [1, 1]);
    compare('shift', load.shift, shift);
  }
  const {reference, map} = plannedCover(request.view, request.screen, settings);
  compare('planned focal', reference.focal / cover.reference.focal, 1);
  compare('planned size', [reference.width, reference.height], planned.size);
  for (let x = 0; x < 20; ++x) {
    const p = [reference.width * (x + 0.5) / 20, reference.height * (0.3 + 0.02 * x)];
    compare('planned map', map.imageFromPinhole(p), cover.map.imageFromPinhole(p));
  }
  for (const {to, eye, turn, zoom, ahead} of all.motion.motions) {
    const motion = motionBetween(all.motion.from, to, 0.1);
    compare('motion', [...motion.eye, ...motion.turn, motion.zoom], [...eye, ...turn, zoom]);
    const there = viewAhead(to, motion, 0.05);
    compare('ahead', [...there.eye, ...there.target, ...there.up], [...ahead.eye, ...ahead.target, ...ahead.up]);
    compare('ahead fov', there.fov_vertical_degrees, ahead.fov_vertical_degrees);
  }
  const requests = all.requests;
  const planner = new LookPlanner();
  const images = [];
  const underWay = [];
  let count = 0;
  requests.frames.forEach((view, frame) => {
    const seconds = frame * requests.frame_seconds;
    while (underWay.length > 0 && underWay[0].due <= seconds) {
      const {wish, look} = underWay.shift();
      images.push({screen: requests.screen, cover: new ImageCover(wish.planned, ...wish.size, wish.layout, requests.near)});
      images.splice(0, images.length - 4);
      planner.answered(look.sequence, seconds);
    }
    const look = planner.look({view, screen: requests.screen, lenses: [], images, settings: requests.settings, seconds});
    if (look !== null) {
      const wish = requests.asked[count++];
      compare('frames of requests', frame, wish?.frame ?? Infinity);
      compare('views of requests', [...look.view.eye, ...look.view.target, look.view.fov_vertical_degrees],
        [...wish.view.eye, ...wish.view.target, wish.view.fov_vertical_degrees]);
      underWay.push({due: seconds + requests.trip, wish, look});
    }
  });
  compare('number of requests', count, requests.asked.length);
  worst['requests made'] = count;
  const {size, values, smoothed, coded} = all.depth;
  compare('smoothed levels', [...smoothedLevels(Uint16Array.from(values), ...size)], smoothed);
  for (const [codec, bytes] of Object.entries(coded)) {
    compare(`depth in ${codec}`, [...await decodedDepth(codec, Uint8Array.from(bytes), ...size)], values);
    for (const broken of [bytes.slice(0, bytes.length / 2), [], bytes.map((byte) => byte ^ 255)]) {
      const isRefused = await decodedDepth(codec, Uint8Array.from(broken), ...size).then(() => false, () => true);
      compare(`broken depth in ${codec}`, Number(isRefused), 1);
    }
  }
  return worst;
})
