"""New letters from strokes that were learned."""
