"""python FOLDER -f CONNECTION_FILE, as a kernel specification says it: FOLDER is this one.

So Python finds the package beside this file, whatever PYTHONPATH is.
"""

from ipykernel.kernelapp import IPKernelApp

from mechanics_kernel.kernel import MechanicsKernel


class MechanicsApp(IPKernelApp):
    """Without IPython's profile, a folder in the user's home with settings that are not for us."""

    def init_profile_dir(self):
        self.profile_dir = None

    def init_config_files(self):
        pass

    def load_config_file(self, suppress_errors=None):
        pass


MechanicsApp.launch_instance(kernel_class=MechanicsKernel)
