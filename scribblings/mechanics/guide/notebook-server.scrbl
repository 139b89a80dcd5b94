#lang scribble/manual
@(require "../next-pages.rkt")

@title[#:tag "notebook-server"]{For those who run a server of notebooks}

A class works in a browser, on one machine or on a JupyterHub. There the library is one kernel
among others. It keeps no state outside of the folder of a notebook, has no fixed port, and never
writes where it is installed: one copy, which belongs to root, serves everybody.

@section{What a kernel takes}

Each open notebook has two processes, one of Python and one of Racket. Together they take some
160 MB after a first formula and 190 to 205 MB after a first picture.

@commandline{make bench TASK=lab}

measures it on your machine, and thirty kernels that start at once, each with a formula and a
picture. On two processors, busy with other work as well, the last picture was there after 35
seconds; all thirty took 5.3 GB.

A cell that takes more than 2 GB is ended with its process, and told so; the environment variable
@tt{MECHANICS_KERNEL_MEMORY} sets another limit, @tt{500M} say, for a class. That the kernels of
notebooks that nobody looks at are ended is an affair of Jupyter: in
@filepath{jupyter_server_config.py}

@verbatim[#:indent 2]{
c.MappingKernelManager.cull_idle_timeout = 3600
c.MappingKernelManager.cull_connected = True}

ends those that did nothing for an hour. Their definitions are lost then; what is on the page stays.

@section{One machine, many users}

Have the library in a folder that all may read, and compile it there. Then add the kernel to the
Python environment in which the users' servers run, @filepath{/opt/jupyterhub} say:

@commandline{make compile drawing}
@commandline{/opt/jupyterhub/bin/pip install ipykernel ipywidgets psutil}
@commandline{PLTCOLLECTS=$PWD: racket -l- mechanics/lang/command/raco jupyter @(linebreak)
             --prefix /opt/jupyterhub --python /opt/jupyterhub/bin/python}

Where Racket knows the library by @exec{make install}, the last command is
@exec{raco mechanics jupyter} with the same options. A kernel listens to its server alone. As
Jupyter starts it, it does so at ports of the machine, which a key protects but which every user can
reach; in @filepath{jupyter_server_config.py}

@verbatim[#:indent 2]{
c.KernelManager.transport = "ipc"}

takes sockets in a folder of the user's own in their place, as @exec{make lab} does. The path of
that folder may have some 50 characters: @tt{JUPYTER_RUNTIME_DIR} names another one.

@section{A container}

@commandline{docker build -f binder/Dockerfile -t mechanics .}
@commandline{docker run --rm -p 127.0.0.1:8888:8888 mechanics}

makes an image of Debian with Racket, the library, JupyterLab and the kernel, and starts it; the
address with its token is printed. Its user is not root. Notebooks of the examples are in the folder
@filepath{mechanics} of the user's home.

repo2docker and Binder find the recipe in the folder @filepath{binder} by themselves. To a
JupyterHub that spawns containers the image is named as it is: it has
@exec{jupyterhub-singleuser}, in the newest version, or in that of the hub, which the build argument
@tt{JUPYTERHUB} names:

@commandline{docker build -f binder/Dockerfile --build-arg JUPYTERHUB=jupyterhub==6.1.1 .}

A volume over the user's home keeps what the user writes. Nothing else has to be kept.

@next-pages["notebooks" "what a notebook is like for those who work in it"
            "teachers" "worksheets, and the judgment on what a class hands in"
            "sandbox" "how programs of others are kept from the machine"]
