import assert from "node:assert/strict";
import { test } from "node:test";
import { keptWork } from "../../dmp_teach/classroom/lesson/kept_work.js";

/** What a tab keeps, as the browser has it: names are the object's own. */
class Storage {
  getItem(name) {
    return this[name] ?? null;
  }
  setItem(name, text) {
    this[name] = text;
  }
  removeItem(name) {
    delete this[name];
  }
}

test("what is forgotten is forgotten in every lesson and tab of the pupil, and in no other", async () => {
  globalThis.location = { pathname: "/lab" };
  globalThis.sessionStorage = new Storage();
  const end = new AbortController();
  const forgotten = [];
  const open = (key, pupil) =>
    keptWork({ key, pupil }, () => forgotten.push(key + pupil), end.signal);
  const [mine, next, other] = [open("03", "w07"), open("05", "w07"), open("03", "w1")];
  for (const each of [mine, next, other]) each.keep({ values: { width: 2 } });
  assert.deepEqual(mine.read(), { variant: "w07", values: { width: 2 } });
  mine.forget();
  assert.deepEqual([mine.read(), next.read()], [null, null]);
  assert.equal(other.read().variant, "w1");
  await new Promise((resolve) => setTimeout(resolve, 50));
  assert.deepEqual(forgotten, ["03w07", "05w07"]);
  end.abort();
});
