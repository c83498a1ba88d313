"""The paper's claims, with verdicts."""
