"""What a camera sees of moving boxes: which points they hide, and how much of the picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.trajectory import Array

# A box that begins after this part of the way to a point does not hide it: the nib touches it.
_TOUCHING = 0.995


@dataclass(frozen=True, eq=False)
class MovingBoxes:
    """A box round each piece of a robot, at a few moments.

    Args:
        links: The link of each box, B names.
        low: The lowest corner of each in its own frame, shape (B, 3) [m].
        high: The highest corner, shape (B, 3) [m].
        X_world_link: Poses of the boxes, shape (M, B, 4, 4).
    """

    links: tuple[str, ...]
    low: Array
    high: Array
    X_world_link: Array

    def of(self, chosen: NDArray[np.bool_]) -> MovingBoxes:
        """Return some of the boxes, chosen by a mask (B,)."""
        links = tuple(link for link, is_in in zip(self.links, chosen, strict=True) if is_in)
        poses = self.X_world_link[:, chosen]
        return MovingBoxes(links, self.low[chosen], self.high[chosen], poses)

    @property
    def corners(self) -> Array:
        """Corners in the world, shape (M, B, 8, 3) [m]."""
        upper = np.array(list(np.ndindex(2, 2, 2)), dtype=bool)
        own = np.where(upper, self.high[:, None], self.low[:, None])
        X = self.X_world_link
        return np.einsum("mbij,bkj->mbki", X[..., :3, :3], own) + X[..., None, :3, 3]

    def hide(self, eye: Array, points: Array) -> NDArray[np.bool_]:
        """Return whether each box hides each point from an eye (3,), shape (M, B, P).

        A ray meets a box where it is between all three pairs of faces at once (Kay and Kajiya,
        1986).

        Args:
            eye: Where one looks from (3,) [m].
            points: What one looks at, shape (P, 3) [m].
        """
        X = self.X_world_link
        start = (eye - X[..., None, :3, 3]) @ X[..., :3, :3]
        way = (points - eye) @ X[..., :3, :3]
        enters, leaves = np.zeros(1), np.full(1, _TOUCHING)
        with np.errstate(divide="ignore", invalid="ignore"):
            for axis in range(3):
                to_low = (self.low[:, None, axis] - start[..., axis]) / way[..., axis]
                to_high = (self.high[:, None, axis] - start[..., axis]) / way[..., axis]
                enters = np.maximum(enters, np.minimum(to_low, to_high))
                leaves = np.minimum(leaves, np.maximum(to_low, to_high))
        return enters < leaves
