# Everything runs from the checkout: nothing needs to be installed but Racket,
# which `make` installs on Debian and Ubuntu, and nothing is written elsewhere.

RACKET ?= racket
RACO    = $(RACKET) -N raco -l- raco
JOBS   ?= 2
# Of tests one more: some wait for windows, pipes and seconds.
WAITING_JOBS ?= $(shell expr $(JOBS) + 1)

# The checkout comes first among the places where Racket looks for collections, Racket's own
# last.  What is there by your own PLTCOLLECTS stands between; what is no full path Racket refuses.
own-collections := $(shell printf %s "$$PLTCOLLECTS" | tr : '\n' | grep '^/' | tr '\n' :)
export PLTCOLLECTS := $(CURDIR):$(own-collections)
export RACKET

# Where compiled files are kept is your affair; Racket's own are where they always are.
ifdef PLTCOMPILEDROOTS
export PLTCOMPILEDROOTS := $(PLTCOMPILEDROOTS):
endif

# Here sources change: what is compiled is compared with them, whatever is usual with you.
unexport PLT_COMPILED_FILE_CHECK

.PHONY: certify new worksheet handout check autograder
.PHONY: new-file worksheet-file handout-file check-file autograder-file
.PHONY: help demo repl lab lab-installed notebooks run show tex export attack mutants lint \
        lint-texts install uninstall test tests test-quick test-manual test-figures test-attacks test-export test-lab \
        elsewhere bench peers export-python docs pictures clean \
        racket writable libraries editing drawing compile begin-tests known-docs

help:
	@echo 'make demo    a tour in five screens: Lagrange equations, proposed paths, verdicts'
	@echo 'make repl    a prompt with history, completion and help'
	@echo 'make lab     notebooks: JupyterLab with our kernel, in build/lab (installs it there first)'
	@echo 'make notebooks   all examples, worksheets and the guide as notebooks with results, in build/notebooks'
	@echo 'make run     run a file            (FILE=my-system.rkt, ARGS="..." for what it is told)'
	@echo 'make compile compiles the library, which all of these do as well'
	@echo 'make install mechanics in your Racket, in some four minutes    (DOCS=no: one, without it)'
	@echo 'make uninstall   takes it away again'
	@echo 'make show    a file with its results as a page  (FILE=my-system.rkt, OUT=page.html)'
	@echo 'make tex     the same for LaTeX    (FILE=my-system.rkt, OUT=file.tex)'
	@echo 'make export  its systems in C, Python or JAX  (FILE=my-system.rkt, TO=c|python|jax, OUT=folder)'
	@echo 'make new     a worksheet to begin with       (FILE=my-worksheet.rkt)'
	@echo 'make worksheet   its file for students, and the page to hand out (FILE=my-worksheet.rkt)'
	@echo 'make handout the page alone        (FILE=my-worksheet.rkt, TO=html|tex, ANSWERS=1, OUT=...)'
	@echo 'make check   a student, or a class (FILE=answers, WORKSHEET=..., CLASS=list.csv, REPORT=report.html)'
	@echo 'make test    run the tests         (TESTS="file-or-folder ..." for some, SUITES=all for all)'
	@echo 'make test-quick    those that a change concerns: compiles it, and tests for up to a minute'
	@echo 'make test-manual   every example of the manual; make test-figures, the pictures of the book'
	@echo 'make test-attacks   hostile answers, random claims, mutants, certificates given to Coq'
	@echo 'make test-export    exported systems in Python, over Dask and with JAX (installs them in build/export)'
	@echo 'make test-lab     the kernel of notebooks, and notebooks in a browser (installs them in build/lab)'
	@echo 'make attack  random claims of the algebra, judged   (N=2000 of each class, SEED=1, CLASS=...)'
	@echo 'make mutants small changes of the library, which tests are to notice  (ROOM=..., N=10 of each, SEED=1, AGAIN=1)'
	@echo 'make certify proofs for the proof assistant Coq, where it is installed   (FILE=my-system.rkt; without FILE many, NEIGHBOURS=3 of each)'
	@echo 'make lint    requires of which no name is used, long lines, tabs'
	@echo 'make bench   run all benchmarks    (TASK=L2 for one; TASK=lab: thirty kernels)'
	@echo 'make peers   what benchmarks compare with, in a Python environment in build/python'
	@echo 'make docs    build the manual in build/doc'
	@echo 'make pictures    the pictures of the README, of a real DrRacket (Xvfb, xdotool, ImageMagick)'
	@echo 'make clean   remove all that make built'
	@echo 'make elsewhere   demo and test in bare Debian 12 and 13, four places (as root, with debootstrap)'

demo: compile
	@$(call try-to-compile,examples/mechanics/demo.rkt)
	@$(RACKET) examples/mechanics/demo.rkt

# What cannot be compiled, as in a checkout that may only be read, is run from its source; a
# mistake in it is told then.
try-to-compile = $(RACO) make $(1) 2>/dev/null || :

repl: compile editing
	@$(RACKET) -l mechanics/lang/prompt/start

# JupyterLab with our kernel, in build/lab; ARGS is for JupyterLab.
lab: compile drawing
	@.ci/lab.sh start $(ARGS)

# What a container has (binder/Dockerfile).
lab-installed: compile drawing
	@.ci/lab.sh install
	@.ci/lab.sh notebooks

test-lab: compile drawing
	@.ci/lab.sh test

# ONLY=text for those with it in their names
notebooks: writable compile
	@$(call try-to-compile,.ci/notebooks.rkt .ci/notebook-work.rkt scribblings/mechanics/guide.scrbl \
	    scribblings/mechanics/guide-notebook.rkt)
	@$(RACKET) .ci/notebooks.rkt --jobs $(JOBS) $(if $(ONLY),--only "$(ONLY)") build/notebooks

# Racket is to find the package where it is installed, not here.
with-own-collections = env $(if $(own-collections),PLTCOLLECTS='$(own-collections)',-u PLTCOLLECTS)
no-docs := $(filter no No NO,$(DOCS))
install: since := $(shell date +%s)
install: known-docs compile
	@$(call try-to-compile,.ci/install.rkt)
	@$(if $(no-docs),,.ci/ensure-racket.sh manual)
	@$(with-own-collections) $(RACKET) .ci/install.rkt --since $(since) $(if $(no-docs),--no-docs)

known-docs:
	@case '$(DOCS)' in ''|yes|Yes|YES|no|No|NO) ;; \
	    *) echo 'make install: DOCS is yes or no, not $(DOCS)' >&2; exit 2 ;; esac
	@echo 'Installing mechanics: on two processors $(if $(no-docs),a minute,four minutes) ...'

uninstall: racket
	@$(with-own-collections) $(RACKET) .ci/install.rkt --remove

run: compile
	@$(RACKET) -l mechanics/lang/run-file "$(FILE)" $(ARGS)

COMMAND = mechanics/lang/command
show tex: compile
	@if [ -z "$(FILE)" ]; then \
	    echo '$@: which file? as in  make $@ FILE=my-system.rkt' >&2; exit 2; \
	fi
	@$(call try-to-compile,$(COMMAND)/raco.rkt $(COMMAND)/show-program.rkt)
	@$(RACKET) -l- $(COMMAND)/raco $@ $(if $(OUT),-o "$(OUT)") "$(FILE)"

RUN_COMMAND = $(RACKET) -l- $(COMMAND)/raco

export: compile
	@if [ -z "$(FILE)" ]; then \
	    echo '$@: which file? as in  make $@ FILE=my-system.rkt TO=c' >&2; exit 2; \
	fi
	@$(call try-to-compile,$(COMMAND)/raco.rkt $(COMMAND)/export-program.rkt)
	@$(RUN_COMMAND) export $(if $(TO),--to "$(TO)") $(if $(OUT),-o "$(OUT)") \
	    $(foreach s,$(SYSTEM),--system "$(s)") $(if $(ALL),--all) $(if $(LIST),--list) \
	    $(if $(DERIVATIVES),--derivatives) $(if $(REPLACE),--replace) "$(FILE)"

new worksheet handout check autograder: compile
	@if [ -z "$(FILE)" ]; then echo 'make $@ FILE=... ; make help says more' >&2; exit 2; fi
	@$(call try-to-compile,$(COMMAND)/raco.rkt $(COMMAND)/worksheet-files.rkt \
	    $(COMMAND)/check-answers-of.rkt $(COMMAND)/autograder.rkt mechanics/worksheet.rkt \
	    mechanics/answers.rkt \
	    $(COMMAND)/evaluate-submission.rkt)
	@$(MAKE) --no-print-directory -s $@-file

new-file:
	@$(RUN_COMMAND) new "$(FILE)"
worksheet-file:
	@$(RUN_COMMAND) worksheet $(if $(OUT),-o "$(OUT)") $(if $(CLASS),--class "$(CLASS)") \
	    $(if $(STUDENT),--student "$(STUDENT)") "$(FILE)"
handout-file:
	@$(RUN_COMMAND) handout $(if $(TO),--to "$(TO)") $(if $(ANSWERS),--answers) \
	    $(if $(OUT),-o "$(OUT)") "$(FILE)"
check-file:
	@$(RUN_COMMAND) check $(if $(WORKSHEET),--worksheet "$(WORKSHEET)") \
	    $(foreach r,$(REPORT),--report "$(r)") $(if $(GRADESCOPE),--gradescope "$(GRADESCOPE)") \
	    $(if $(CLASS),--class "$(CLASS)") $(if $(STUDENT),--student "$(STUDENT)") \
	    $(if $(POINTS),--points "$(POINTS)") $(if $(MOODLE),--moodle "$(MOODLE)") \
	    $(if $(JSON),--json) "$(FILE)"
autograder-file:
	@$(RUN_COMMAND) autograder $(if $(OUT),-o "$(OUT)") "$(FILE)"

# What takes long says so at once.  SUITES: everyday, manual, figures, export, attacks, or all.
RUN_TESTS = $(RACKET) tests/mechanics/runner/main.rkt --progress --jobs $(WAITING_JOBS)
test: begin-tests writable compile libraries
	@$(call try-to-compile,$(RUNNER))
	@$(RUN_TESTS) $(SUITES:%=--suite %) $(TESTS)

# There is a folder of that name.
tests: test

# Only what the chosen tests load is compiled.
test-quick: writable racket
	@$(call try-to-compile,$(RUNNER))
	@$(RUN_TESTS) --quick

test-manual test-figures test-attacks:
	@$(MAKE) --no-print-directory test SUITES=$(@:test-%=%)

RUNNER = tests/mechanics/runner/main.rkt tests/mechanics/runner/worker.rkt

begin-tests:
	@echo 'Looking for what is to be compiled ...'

# N mutants of each room, or of ROOM alone; what is known of one is kept in build/mutants.rktd.
# They are tried in a copy, where no procedure is compiled into another's code.
JOBS ?= 2
MUTANTS = build/mutants
mutants: N = 10
mutants: writable racket
	@mkdir -p $(MUTANTS)/build && find $(MUTANTS) -name '*.rkt' -delete
	@git ls-files -co --exclude-standard | tar cf - -T - | tar xf - -C $(MUTANTS)
	@touch build/tests.fasl build/mutants.rktd
	@ln -sf ../../tests.fasl ../../mutants.rktd $(MUTANTS)/build
	@cd $(MUTANTS) && export PLTCOLLECTS='$(CURDIR)/$(MUTANTS):' && \
	  { find mechanics tests -name '*.rkt' -not -path '*fixture*' | \
	    xargs -P $(JOBS) -n 20 $(RACO) make --disable-inline 2>/dev/null || :; } && \
	  $(RACKET) tests/mechanics/support/mutation/random-mutants.rkt --count $(N) --seed $(SEED) \
	    --jobs $(JOBS) $(if $(ROOM),--room $(ROOM)) $(if $(AGAIN),--again)

# N claims of each class; CLASS=disguised for identities in disguise alone.
N    ?= 2000
SEED ?= 1
attack: writable compile
	@mkdir -p build
	@$(RACO) make tests/mechanics/attack/main.rkt tests/mechanics/attack/worker.rkt
	@$(RACKET) tests/mechanics/attack/main.rkt --count $(N) --seed $(SEED) --jobs $(JOBS) \
	    $(if $(CLASS),--class $(CLASS))

# Certificates of claims and examples, checked by Coq, and false neighbours, which it rejects.
NEIGHBOURS ?= 3
certify: writable compile
ifdef FILE
	@$(call try-to-compile,$(COMMAND)/raco.rkt $(COMMAND)/certify-program.rkt)
	@$(RUN_COMMAND) certify $(if $(OUT),-o "$(OUT)") "$(FILE)"
else
	@$(call try-to-compile,$(CERTIFY))
	@$(RACKET) $(CERTIFY) --neighbours $(NEIGHBOURS) $(if $(ONLY),--only "$(ONLY)") $(if $(RECORD),--record)
endif

CERTIFY = tests/mechanics/support/certification/certify-all.rkt

lint: compile
	@$(call try-to-compile,.ci/lint.rkt)
	@$(RACKET) .ci/lint.rkt $(FILES)

# Of that what takes a second.
lint-texts: racket
	@$(RACKET) .ci/lint.rkt --texts $(FILES)

elsewhere:
	@.ci/elsewhere.sh $(PLACES)

# TASK=lab: thirty kernels of notebooks at once, as on the server of a class.
bench: writable compile
ifeq ($(TASK),lab)
	@.ci/lab.sh bench
else
	@$(RACO) make -j $(JOBS) $(wildcard tests/mechanics/bench/*.rkt)
	@$(RACKET) tests/mechanics/bench/main.rkt $(TASK)
endif

# What exported systems need in Python, with its versions; once there, their tests use it.
export-python: writable
	@python3 -m venv build/export
	@build/export/bin/pip install --quiet -r tests/mechanics/scale/export/requirements.txt

test-export: writable compile export-python
	@$(call try-to-compile,$(RUNNER))
	@MECHANICS_EXPORT_ALL=1 $(RUN_TESTS) tests/mechanics/scale/export

peers: writable
	@python3 -m venv build/python
	@build/python/bin/pip install --quiet heyoka casadi numpy scipy sympy jax diffrax

docs: writable compile
	@echo 'Building the manual: some three minutes ...'
	@$(call try-to-compile,.ci/docs.rkt)
	@$(RACKET) .ci/docs.rkt --jobs $(JOBS) build/doc
	@echo 'The manual begins at build/doc/mechanics/index.html'

# To be made again when results look different, and committed.
pictures: writable compile
	@.ci/pictures/make.sh

# Files are compiled in parallel where there are many.
ROOTS = mechanics/main.rkt mechanics/lang/help/card-table.rkt \
        mechanics/lang/help/search-table.rkt mechanics/lang/prompt/start.rkt \
        mechanics/lang/prompt/editor.rkt mechanics/lang/run-file.rkt

compile: racket
	@$(RACKET) .ci/compile.rkt --jobs $(JOBS) $(ROOTS:%=--root %) mechanics

racket:
	@.ci/ensure-racket.sh

# For what is made in build/ or beside its sources.
writable:
	@[ -w . ] || { echo "make $(MAKECMDGOALS) writes in $(CURDIR), which you may not." \
	    "Do it in a copy of the checkout that is yours." >&2; exit 1; }

libraries:
	@.ci/ensure-racket.sh libraries

# Line editing at the prompt.
editing:
	@.ci/ensure-racket.sh editing

# Pictures in notebooks.
drawing:
	@.ci/ensure-racket.sh drawing

clean:
	rm -rf build
	find . -name compiled -type d -prune -exec rm -rf {} +
