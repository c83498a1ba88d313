// Moves a control 60 times a second and sees when the page shows it. Evaluated in the page by
// `browser.py`: what is fired at a place, and what is then seen, are the two functions given.

/**
 * @param {{
 *   fire: (place: number) => void, look: () => string, places: number, calibrate: boolean,
 *   seconds: number, rate?: number,
 * }} how `places` are numbered from 0; a picture that the kernel makes is known by what is seen once
 *   the page has come to rest at each place, and one that the page makes by being new
 */
async (how) => {
  const { fire, look, places, calibrate, seconds, rate = 60 } = how;
  const frame = () => new Promise((done) => requestAnimationFrame(() => done(performance.now())));
  // What is seen once it has become new, or has not for 9 s, and then stood still.
  const rest = async (/** @type {string} */ known, still = 400) => {
    const begin = performance.now();
    while (look() === known && performance.now() < begin + 9000) await frame();
    let [before, since] = [look(), performance.now()];
    while (performance.now() - since < still) {
      await frame();
      if (look() !== before) [before, since] = [look(), performance.now()];
    }
    return before;
  };
  /** @type {Map<string, number>} */
  const placeOf = new Map();
  const go = async (/** @type {number} */ place, still = 400) => {
    const before = look();
    fire(place);
    return await rest(before, still);
  };
  // A slider may go through all places between: they must be over.
  await go(1, 2000);
  for (let place = 0; calibrate && place < places; place += 1) placeOf.set(await go(place), place);
  if (calibrate && placeOf.size < places) throw new Error(`only ${placeOf.size} pictures differ`);
  await go(0, 2000);

  // There and back again, so that neighbours are near.
  const way = Array.from({ length: 2 * places - 2 }, (_, i) =>
    i < places ? i : 2 * places - 2 - i,
  );
  const events = [];
  const shown = [];
  const begin = performance.now();
  const timer = setInterval(() => {
    // An event that is late was due all the same: it counts from then.
    while (events.length < seconds * rate) {
      const due = begin + (1000 * events.length) / rate;
      if (due > performance.now()) return;
      const place = way[(events.length + 1) % way.length];
      events.push({ due, place });
      fire(place);
    }
    clearInterval(timer);
  }, 1);
  let [before, next, frames] = [look(), 0, 0];
  while (performance.now() < begin + 1000 * seconds) {
    const now = await frame();
    frames += 1;
    const seen = look();
    if (seen === before || !seen) continue;
    before = seen;
    // The last event that it can be: slow pictures are taken for quicker ones, never for slower.
    let at = events.length - 1;
    while (calibrate && at >= next && events[at].place !== placeOf.get(seen)) at -= 1;
    if (at < next) continue;
    next = at + 1;
    shown.push(now - events[at].due);
  }
  clearInterval(timer);
  await rest("", 2000);
  const isRight = !calibrate || placeOf.get(look()) === events[events.length - 1].place;
  return { latencies: shown, frames: frames / seconds, events: events.length / seconds, isRight };
};
