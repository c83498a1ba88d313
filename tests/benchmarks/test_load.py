"""What the load is made of: how much a kernel may take."""

import psutil
from jupyter_client.manager import start_new_kernel

from tests.benchmarks.load_hub import memory_of
from tests.benchmarks.load_pupil import PANEL

MOST = 70  # [MB]


def test_a_kernel_with_a_panel_is_small():
    manager, client = start_new_kernel()
    try:
        reply = client.execute_interactive(PANEL, timeout=60, output_hook=lambda told: None)
        assert reply["content"]["status"] == "ok"
        assert memory_of(psutil.Process(manager.provisioner.pid)) < MOST
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
