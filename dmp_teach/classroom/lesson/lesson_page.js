// A lesson as a page of its own: its steps but for the challenge, which Python checks.

import { showPage } from "../../views/standalone.js";
import { render } from "./lesson.js";

showPage(render, {
  send(model, { kind, bet, step }) {
    const progress = { ...model.get("progress") };
    if (kind === "bet") progress.bet = bet;
    else if (kind === "reveal") progress.revealed = true;
    else if (kind === "step") progress.step = step;
    else return;
    const isTruth = progress.step === "bet" && progress.revealed;
    const told = model.get("told");
    const card = { ...model.get("card"), bet: told[progress.bet] ?? told.line };
    const values = model.get("start");
    const seen = model.get("seen")[isTruth ? "truth" : progress.step];
    const drawing = model.get("drawing") + 1;
    for (const [name, value] of Object.entries({ values, card, ...seen, progress, drawing }))
      model.set(name, value);
  },
});
