"""Kernels: the bumps that share out the phase. Every file of this folder that adds one is found."""

from importlib import import_module
from pkgutil import iter_modules

from dmp_teach.dmp.kernels.bank import Kernels as Kernels
from dmp_teach.dmp.kernels.kernel import KERNELS as KERNELS
from dmp_teach.dmp.kernels.kernel import Kernel as Kernel
from dmp_teach.dmp.kernels.placement import PLACEMENTS as PLACEMENTS
from dmp_teach.dmp.kernels.sums import Cells as Cells
from dmp_teach.dmp.kernels.sums import Overlap as Overlap
from dmp_teach.dmp.kernels.sums import ratio as ratio

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")
