"""python FOLDER -f CONNECTION_FILE, as a kernel specification says it: FOLDER is this one.

So Python finds the package beside this file, whatever PYTHONPATH is.
"""

from ipykernel.kernelapp import IPKernelApp

from mechanics_kernel.kernel import MechanicsKernel

IPKernelApp.launch_instance(kernel_class=MechanicsKernel)
