// A lesson as a page of its own: its steps but for the challenge, which Python checks.

import { showPage } from "../../views/standalone.js";
import { renderLesson } from "./lesson.js";

showPage(renderLesson, {
  send(model, { kind, bet, step }) {
    const progress = { ...model.get("progress") };
    if (kind === "bet") progress.bet = bet;
    else if (kind === "reveal") progress.revealed = true;
    else if (kind === "step") progress.step = step;
    else return;
    const which = typeof progress.bet === "string" ? progress.bet : "drawn";
    const isTruth = progress.step === "bet" && progress.revealed;
    const seen = model.get("seen")[isTruth ? `truth ${which}` : progress.step];
    const card = { ...model.get("card"), bet: model.get("told")[which] };
    const values = model.get("start");
    const drawing = model.get("drawing") + 1;
    for (const [name, value] of Object.entries({ values, card, ...seen, progress, drawing }))
      model.set(name, value);
  },
});
