#lang scribble/manual
@(require (for-label mechanics mechanics/book)
          "../eval.rkt"
          "../next-pages.rkt")

@(define session (make-session '(require mechanics/book)))

@title[#:tag "guide-scales"]{From a laptop to a cluster}

One pendulum is a trajectory; two thousand are a question about all of them. The system here is
always the same, and what changes is how many starts there are.

@section{One process}

@racket[evolve-ensemble] follows each start to the end and returns the last states, in the order
of the starts:

@examples[#:eval session #:label #f
(define (swing m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define (starts n) (for/list ([k n]) (up 0 (* 0.1 k) 0)))
(define (rows n) (for/list ([k n]) (list 1.0 (+ 1 (* 0.01 k)) 9.8)))
(evolve-ensemble swing (starts 3) 10 #:parameters (rows 3) #:jobs 1)]

The system is compiled once, whatever the parameters. What is wanted of each start is said by
@racket[#:collect], what is made of all by @racket[#:fold]: then a million starts, which may be
any sequence, need no more memory than a few.

@examples[#:eval session #:label #f
(evolve-ensemble swing (starts 20) 10 #:parameters (rows 20) #:jobs 1
                 #:collect (lambda (s) (square (ref s 2))) #:fold max #:initial 0)]

@section{Sections}

With @racket[#:events] the value of a start is what happened on its way: here when each pendulum
comes through the bottom from the right.

@examples[#:eval session #:label #f
(define bottom (event (lambda (s) (ref s 1)) #:direction 'falling))
(evolve-ensemble swing (cdr (starts 4)) 3 #:parameters (cdr (rows 4)) #:jobs 1
                 #:events bottom
                 #:collect (lambda (last all) (map occurrence-time all)))]

@section{All cores}

Without @racket[#:jobs] there are as many workers as cores. Each is a process of its own, which
takes about half a second to begin: what takes less than a few seconds is done sooner by one.
@racket[sweep] makes the rows in which one parameter, told by its name, changes. A run of hours
wants a checkpoint, @racket[#:checkpoint "swings.ensemble"]: stopped by whatever it may be, Ctrl-C,
a full disk or a power cut, the same call goes on where it was, and so does a call with more starts
behind those.

@section{Tables for other programs}

@racket[write-table] writes what came out, row by row: as text, or as arrays that NumPy loads.
@racket[read-table] reads such files, and @racket[fit-motion] finds the parameters for which a
motion comes closest to what was measured.

@examples[#:eval session #:label #f
(define file (build-path (find-system-path 'temp-dir) "swings.npy"))
(write-table (evolve-ensemble swing (starts 3) 10 #:parameters (rows 3) #:jobs 1) file)
(table-rows (read-table file) (up 't 'q 'v))
(delete-file file)]

@section{A program in C}

@racket[export-system] writes the system as C, with the method of integration and a loop over
the starts. Nothing of Racket is needed where it runs.

@codeblock|{
#lang mechanics
(require mechanics/book)
(export-system (Lagrangian->state-derivative (L-pendulum 'g 'm 'l))
               (up 't 'theta 'thetadot)
               #:parameters '(m l g) #:name "pendulum" #:folder "pendulum-c")
}|

@verbatim|{
cd pendulum-c
make
./pendulum 100 1e-9 < starts > finals
}|

A line of @tt{starts} has the variables and then the parameters. Where a branch of periodic orbits
(@secref["branches"]) is exported, @filepath{starts.txt} and @filepath{periods.txt} hold its orbits.

From the command line the same is done with a program as it stands:

@commandline{raco mechanics export swing.rkt --to c}

or, in a checkout, @exec{make export FILE=swing.rkt TO=c}. The program is run, and what it hands to
@racket[export-system] becomes a folder, in the language and at the place that the command names;
the program itself writes nothing then. If it calls @racket[export-system] for no system, those are
exported whose motions it follows (by @racket[evolve], @racket[evolve-trajectory],
@racket[state-advancer], @racket[evolve-ensemble], sections of motions): under the name of the
program's function or of its file, with variables @tt{t}, @tt{q}, @tt{v}; numbers given to what
makes a state derivative, as by @racket[(evolve maker 1.0 9.8)], become parameters @tt{p0},
@tt{p1}, and other numbers stay. What is printed last is a line to try it with, the program's own
start in it. Where there are several systems, @exec{--list} tells them and @exec{--system swing},
once or more often, or @exec{--all} says which; @exec{-o} names the folder, @exec{--derivatives}
adds the derivatives of the rates, @exec{--replace} writes an earlier export anew. Submodules are
not run.

@section{A cluster, a graphics processor}

With @racket[#:language 'python] the same C comes as a package of Python with a function that hands
batches of starts to a cluster of Dask, does those of a worker that has died again, and keeps a
checkpoint. With @racket[#:language 'JAX] it is a module for JAX, which compiles for graphics
processors as well.

@section{Speeds}

Two thousand pendulums of slightly different lengths to @math{t = 100} with a tolerance of
1e-9, processor time on one core of a virtual machine that had other work as well:

@tabular[#:style 'boxed #:sep @hspace[2] #:row-properties '(bottom-border ())
 (list (list "" "seconds" "motions a second")
       (list @elem{@racket[evolve-ensemble], Taylor (@racket['auto])} "1.4" "1,400")
       (list @elem{@racket[evolve-ensemble], @racket['Dormand-Prince-853]} "1.4" "1,400")
       (list "exported C, the same steps as that" "1.0" "2,000"))]

And ten thousand pendulums with a shaken pivot, to the same time with the same tolerance, as
@exec{make bench TASK=ensembles} does it, on two cores that had nothing else to do; what is compiled
before the first motion is not counted for those in Python:

@tabular[#:style 'boxed #:sep @hspace[2] #:row-properties '(bottom-border ())
 (list (list "" "seconds" "processor time" "motions a second")
       (list @elem{@racket[evolve-ensemble], one job} "6.6" "6.6" "1,500")
       (list @elem{@racket[evolve-ensemble], two jobs} "3.4" "6.8" "2,900")
       (list "exported C, one thread" "9.0" "9.0" "1,100")
       (list "exported C, two threads" "4.8" "9.4" "2,100")
       (list "exported to JAX, order 5" "13.6" "21.6" "740")
       (list "exported to JAX, followed by diffrax, order 8" "17.0" "24.1" "590")
       (list "heyoka, Taylor's method" "8.7" "10.9" "1,100"))]

Smooth motions are followed by Taylor's method here, which takes fewer steps than the C does, and
of each member the parameters are numbers when its coefficients are computed: so one core of ours
is ahead of one of C. Of two jobs each takes a third of a second to begin.

So the C is worth its folder where there is no Racket, and within other programs; the cluster when
one machine would take a night.

@section{Agreement of the results}

Rates and steps of the C are ours to the last bit, apart from functions of C's library that
round differently than ours, hyperbolic ones mostly, and from mass matrices of more than eight
coordinates, which we add up in another order; the tests compare them so. JAX's compiler
puts sums into another order: rates agree to a few units of the last digit. Motions agree within
the tolerance, as long as it means anything: where motions are chaotic, errors grow by a factor
in each Lyapunov time, and after some thirty of these two runs that differ in the last bit have
nothing in common but their statistics. A checkpoint of one does not mend that; the question has
to be one that statistics answer.

@next-pages["ensembles" "every name about many motions, and exported systems"
            "numbers-guide" "methods and their accuracy"
            "compiled-functions" "functions as machine code"]
