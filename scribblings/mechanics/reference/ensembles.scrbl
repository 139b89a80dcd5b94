#lang scribble/manual
@(require (for-label mechanics mechanics/book)
          "../eval.rkt" "../citation.rkt")

@(define session (make-session '(require mechanics/book)))

@title[#:tag "ensembles" #:style '(toc)]{Ensembles, and systems in other languages}

Many motions of one system: on all cores of this machine, or elsewhere by a program in C, in Python
or for JAX.

@local-table-of-contents[]

@section{Many motions}

@defproc[(evolve-ensemble [maker (or/c (-> state rates) (-> parameter ... (-> state rates)))]
                          [starts (sequence/c state)] [end real?]
                          [#:parameters parameters (or/c (sequence/c (listof parameter)) #f) #f]
                          [#:events events (or/c event? (listof event?)) '()]
                          [#:tolerance tolerance real? 1e-10]
                          [#:method method name-of-method 'auto]
                          [#:collect collect (or/c (-> state value) #f) #f]
                          [#:observe observe (-> exact-nonnegative-integer? value any) void]
                          [#:fold fold (or/c (-> value so-far so-far) #f) #f]
                          [#:initial initial so-far (void)]
                          [#:jobs jobs exact-positive-integer? (processor-count)]
                          [#:batch batch exact-positive-integer? 16]
                          [#:checkpoint file (or/c path-string? #f) #f]
                          [#:progress? progress? boolean? (report-progress)])
         (or/c (listof value) so-far)]{

Follows every start, a state of any shape, to the time @racket[end], and returns the list of the
last states in the order of the starts. @racket[maker] is a state derivative. With
@racket[parameters], a list of finite numbers and tuples of numbers for each start, it is a
function of these that returns a state derivative, as for @racket[evolve]. A state is a tuple of
real numbers; its rates are a tuple of the same shape. Any consistent units will do.

@examples[#:eval session
(define starts (for/list ([k 5]) (up 0 (* 0.3 k) 0)))
(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1.0 1.0)))
(evolve-ensemble pendulum starts 2 #:jobs 1)]

@racketvarfont{collect} makes the value that is kept of a last state. The workers run it if it can
be compiled; otherwise the calling process does. @racket[fold] is called with each value and with
what it returned for the values before, at first with @racket[initial], which must be given with it.
@racket[observe] is called with each index and value. Both get the values in the order of the
starts, whichever motion is finished first, so that sums are the same each time.

@examples[#:eval session #:label #f
(define (swing m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(evolve-ensemble swing starts 2 #:parameters (for/list ([k 5]) (list 1.0 (+ 1 (* 0.1 k)) 9.8))
                 #:collect (lambda (s) (square (ref s 2))) #:fold + #:initial 0 #:jobs 1)]

The memory is that of the values returned. As measured, a last state @racket[(up t q v)] takes 130
bytes, one of two coordinates, @racket[(up t (up x y) (up vx vy))], 280, a number made by
@racketvarfont{collect} 30, and an occurrence some 200, so that the last states of a million
pendulums take 130 MB; each of the @racket[jobs] takes 90 MB, whatever their number. With
@racket[fold] and a result that does not grow, such as a sum, a histogram or a maximum, a million
starts take no more memory than a hundred: values are dropped as soon as they are folded. The
starts, which may be any sequence, take as much as last states do if they are a list, and nothing
if they are made one by one, as a generator does.

With @racket[events] (@racket[event]) the value of a start is not its last state but the list of
occurrences on its way, in their order (@racket[occurrence-time], @racket[occurrence-state]). A
terminal event ends its motion. @racketvarfont{collect} then receives the last state and that list.
An ensemble of sections:

@examples[#:eval session #:label #f
(define bottom (event (lambda (s) (ref s 1)) #:direction 'falling))
(evolve-ensemble pendulum (cdr starts) 2 #:events bottom #:jobs 1
                 #:collect (lambda (last all) (map occurrence-time all)))]

Batches of starts are followed by worker processes, @racket[jobs] of them but never more than four
for each core. A worker receives the list of instructions that @racket[maker] compiles to. If it
dies, another one takes its place and repeats its batches. The calling process itself follows a
small number of starts, and systems or events that cannot be compiled, such as those that decide
something by their state. Methods are given by name (@racket[ode-integration-method]).

With a @racket[file] as checkpoint, finished batches are written there. The same call goes on from
it, says in a note how many starts are done, and so does a call with more starts behind those. A
file that is no checkpoint, or is one of other starts, of another system or of batches of another
size, is refused and left as it is. If the disk is full the run ends with an error, and the
checkpoint stays good. Batches have checksums: batches that the disk has damaged are reported on the
error port and repeated. A damaged beginning of the file, which tells whose checkpoint it is, is an
error.

A start that cannot be followed to the end has an @racket[ensemble-failure?] as its value; the
others go on. An error tells the index of a start or of parameters that have another shape or are
not finite numbers; an ensemble without starts is an error, too.

@racket[evolve-trajectory] follows a single start; @racket[plot-point] draws the results. A
program in another language does the same many times: @racket[export-system].}

@deftogether[(@defproc[(ensemble-failure? [x any/c]) boolean?]
              @defproc[(ensemble-failure-index [failure ensemble-failure?])
                       exact-nonnegative-integer?]
              @defproc[(ensemble-failure-message [failure ensemble-failure?]) string?]
              @defproc[(ensemble-failure-state [failure ensemble-failure?]) (or/c state #f)])]{

The failure of a start that could not be followed: its index, the reason, and the last good state,
or @racket[#f] if there is none.

@examples[#:eval session
(define falling (Hamiltonian->state-derivative
                  (lambda (s) (- (* 1/2 (square (ref s 2))) (/ 1 (ref s 1))))))
(define ends (evolve-ensemble falling (list (up 0 1.0 0.0) (up 0 1.0 2.0)) 3))
(map ensemble-failure? ends)
(ensemble-failure-index (car ends))
(time (ensemble-failure-state (car ends)))
(ensemble-failure-message (car ends))]}

@defproc[(sweep [parameters (listof (list/c symbol? any/c))] [name symbol?] [values sequence?])
         (listof list?)]{

Rows of parameters, for @racket[evolve-ensemble], in which the one of that name takes one of the
@racket[values] after another and the others keep theirs, in the order in which they are given. It
is an error if there is no parameter of that name.

@examples[#:eval session
(sweep '((g 9.8) (m 1) (l 1)) 'l '(1 1.5 2))
(define (pendulum-of g m l) (Lagrangian->state-derivative (L-pendulum g m l)))
(evolve-ensemble pendulum-of (list (up 0 1 0) (up 0 1 0) (up 0 1 0)) 2
                 #:parameters (sweep '((g 9.8) (m 1) (l 1)) 'l '(1 1.5 2)) #:jobs 1)
(eval:error (sweep '((g 9.8) (m 1) (l 1)) 'length '(1 2)))]}

@section{Systems in other languages}

@defproc[(export-system [derivative (or/c (-> state rates) branch?)]
                        [example state-of-numbers-or-symbols]
                        [#:language language (or/c 'C 'python 'JAX) 'C]
                        [#:name name (or/c string? symbol?) "motion"]
                        [#:folder folder path-string? (format "~a-~a" name language)]
                        [#:parameters parameters (or/c (listof symbol?) #f) #f]
                        [#:derivatives? derivatives? boolean? #f]
                        [#:replace? replace? boolean? #f])
         string?]{

Writes a folder with a program that follows the motions of a system, made of the same list of
instructions that is compiled here, and returns the name of the folder. @racket[example] is a state;
its symbols name the variables. For numbers in a state @racket[(up t q v)] the names are @tt{t},
@tt{q} and @tt{v}, or @tt{p} for Hamilton's equations; several coordinates are numbered, @tt{q0},
@tt{q1}. In any other state the names are @tt{x} with the indices that @racket[ref] takes, as
@tt{x1_0}. A name that belongs to a parameter already gets an underscore. Other symbols in the
derivative become parameters of the program, in the order of @racket[parameters] or of the alphabet;
numbers stay numbers.

@codeblock|{
#lang mechanics
(require mechanics/book)
(export-system (Lagrangian->state-derivative (L-pendulum 'g 'm 'l))
               (up 't 'theta 'thetadot) #:name "pendulum")
}|

writes a folder @filepath{pendulum-C}, with this in @filepath{pendulum.c}:

@verbatim|{
void pendulum_derivative(const double *y, const double *p, double *dy)
{
    const double theta = y[1];
    const double thetadot = y[2];
    const double g = p[0];
    const double l = p[1];
    const double m = p[2];
    dy[0] = 1.0;
    dy[1] = thetadot;
    dy[2] = -(sin(theta) * (l * (g * m)) / (l * (l * m)));
}
}|

@itemlist[
 @item{@tt{'C}: C99 without dependencies: the rates and, with @racket[derivatives?], their
 derivatives by variables and parameters; the method of Dormand and Prince of order 8 with
 interpolation; ensembles under OpenMP; a program for the command line, a library and a
 @tt{Makefile}. Rates are those of our own code to the last bit, except where a function of C's
 library rounds differently or more than eight coordinates share a mass matrix, and motions take
 the steps of @racket['Dormand-Prince-853].}
 @item{@tt{'python}: a package that calls this C with arrays of NumPy, and ensembles over a
 cluster of Dask, with batches that are done again when a worker dies and a checkpoint.}
 @item{@tt{'JAX}: one module, in 64 bits: the rates, steps of Runge and Kutta's method,
 steps of Dormand and Prince's of order 5, which @tt{jit}, @tt{vmap} and forward derivatives
 go through.}]

A new folder is written whole or not at all. An existing folder is refused unless it holds an
export and @racket[replace?] is true: then files of the export are written over, and no others. An
error names operations that cannot be exported: a decision by the state, or an unknown function. A
motion under constraints (@racket[constrained-state-derivative]) is exported by its rates; its
steps are not brought back to the constraints there.

A branch (@secref["branches"]) in place of the derivative is exported as the system of its family,
whose parameter is the symbol in @racket[parameters], else @racket['parameter]. Beside it are
written its points, @filepath{starts.txt}, which the program in C reads, a line for each with the
value of the parameter, and of orbits their periods, @filepath{periods.txt}.

A program says by @racket[export-system] what @exec{raco mechanics export} exports of it
(@secref["guide-scales"]): run by that command, it writes nothing itself, and
@racket[language], @racket[folder] and @racket[replace?] are the command's. Many motions here:
@racket[evolve-ensemble].

@examples[#:eval session
(eval:error (export-system (lambda (s) (up 1 (if (> (ref s 1) 0) 1 -1))) (up 't 'x)))]}
