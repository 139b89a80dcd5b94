"""python -m mechanics_kernel -f CONNECTION_FILE, as a kernel specification says it."""

from ipykernel.kernelapp import IPKernelApp

from .kernel import MechanicsKernel

IPKernelApp.launch_instance(kernel_class=MechanicsKernel)
