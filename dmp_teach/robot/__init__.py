"""The Fetch: its model, the page, the pen's plan and the joints that follow it."""
