#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot)
          "../eval.rkt" "../citation.rkt")

@(define session (make-session '(require mechanics/book)
                               '(current-directory (find-system-path 'temp-dir))))

@title[#:tag "tables-and-fits"]{Tables in files, and motions fitted to data}

Numbers that go to other programs, and numbers that were measured.

@section{Tables}

@defproc[(write-table [data (or/c trajectory? branch? number-table? (sequence/c row))]
                      [file path-string?]
                      [#:names names (or/c (listof (or/c symbol? string?)) #f) #f]
                      [#:times times (or/c (listof real?) #f) #f])
         void?]{

Writes a table to a file, over what was there, whole or not at all. The end of its name says the
format:

@itemlist[
 @item{@filepath{.csv}: text by RFC 4180. The first line has the names of the columns; numbers have
 the fewest digits that are read back as the same flonum, and @tt{nan}, @tt{inf} and @tt{-inf} are
 what is no finite number.}
 @item{@filepath{.npy}: an array of records in NumPy's format. After @tt{a = numpy.load(file)},
 @tt{a['q']} is a column.}
 @item{@filepath{.npz}: an archive with an array for each column, in NumPy's format.
 @tt{numpy.load(file)['q']} is a column, and it is the smallest of the three.}]

A trajectory has a row for the end of each step, or for each of the @racket[times]; if its state
does not tell the time, the time is the first column. A branch has a row for each point: the
parameter, the state, the period of an orbit, and 1 where it is stable. Any other sequence has a row
for each item: a state of any shape, a point of a section, an occurrence, a number, a list of
numbers, or a failure of an ensemble, whose row is not-a-number throughout, so that row @italic{k}
is that of start @italic{k}. Items are taken one by one, and a million of them take no more memory
than a hundred if they are made as they are taken.

Without @racket[names] the columns of a state @racket[(up t q v)] are @tt{t}, @tt{q} and @tt{v}, or
@tt{p} where it is @racket[down]; several coordinates are numbered, @tt{q0}, @tt{q1}. Columns of
anything else are @tt{x0}, @tt{x1}. Any consistent units will do. It is an error if a row has
another number of numbers than the first, or something that is not a real number, and what the file
held before stays.

@examples[#:eval session
(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1.2)))
(define swing (evolve-trajectory pendulum (up 0 1 0) 3))
(write-table swing "swing.csv" #:times '(0 1 2 3))
(read-table "swing.csv")]}

@defproc[(read-table [file path-string?]
                     [#:names names (or/c (listof (or/c symbol? string?)) #f) #f]
                     [#:columns columns (or/c (listof (or/c symbol? string?)) #f) #f]
                     [#:fold fold (or/c (-> row so-far so-far) #f) #f]
                     [#:initial initial so-far (void)])
         (or/c number-table? so-far)]{

Reads a table that @racket[write-table], NumPy or another program has written, in the format that
the name of the file tells. Columns of a plain array of two dimensions are @tt{x0}, @tt{x1}, and in
an archive they are named after the array. @racket[names] are those of all columns, of a CSV file
without a line of names or in place of what an array has. @racket[columns] are the names of those
that are wanted; in a CSV file others may hold any text.

With @racket[fold], no table is made: it is called with each row, an @racket[up] tuple, and with
what it returned for the rows before, at first with @racket[initial]. A file of any length is read
in the same memory.

It is an error if a column is missing, a row has too few or too many fields, or one of them is no
number; the message tells line and column. So is an array of numbers that are not real.

@examples[#:eval session
(read-table "swing.csv" #:columns '(t q))
(read-table "swing.csv" #:fold (lambda (row most) (max (ref row 1) most)) #:initial -inf.0)
(eval:error (read-table "swing.csv" #:columns '(tme q)))]}

@deftogether[(@defproc[(number-table? [x any/c]) boolean?]
              @defproc[(table-names [table number-table?]) (listof symbol?)]
              @defproc[(table-length [table number-table?]) exact-nonnegative-integer?]
              @defproc[(table-column [table number-table?] [name (or/c symbol? string?)])
                       (listof flonum?)]
              @defproc[(table-rows [table number-table?] [like (or/c state #f) #f])
                       (listof state)])]{

A table: the names of its columns, the number of its rows, the numbers of a column, and the rows as
@racket[up] tuples or, like the state @racket[like], as structures of its shape. It is an error if
there is no column of that name, or @racket[like] has another number of scalars than there are
columns. A table keeps eight bytes for each number.

@examples[#:eval session
(define table (read-table "swing.csv"))
(number-table? table)
(table-names table)
(table-length table)
(table-column table 'q)
(table-rows table (up 't 'q 'v))]}

@section{Fits}

@defproc[(fit-motion [maker (or/c (-> state rates) (-> parameter ... (-> state rates)))]
                     [start state] [data (or/c number-table? (listof row))]
                     [#:parameters parameters (listof (list/c symbol? real?)) '()]
                     [#:hold names (listof symbol?) '()]
                     [#:measured measured (or/c (-> state value) #f) #f]
                     [#:deviation deviation (or/c positive-real? (listof positive-real?) #f) #f]
                     [#:tolerance tolerance real? 1e-10]
                     [#:progress? progress? boolean? (report-progress)])
         motion-fit?]{

Finds the start and the parameters of a system for which its motion comes closest to measured data:
those for which the squares of the differences add up to the least. Each row of @racket[data] is a
time and what was measured then, a table whose first column is the time or a list of tuples or
lists. @racket[measured] is the function of the state that was measured, a number or a tuple;
without it, it is the whole state but for the time. The data may be in any order, none before the
time of the start, which is 0 if the state does not tell it.

@racket[start] and @racket[parameters], names with first values in the order in which
@racket[maker] takes them, are where the search begins. Names of the state's variables are those
that @racket[write-table] gives. Those in @racketvarfont{names} keep their values.

@racket[deviation] is the standard deviation of what was measured, one for all columns or a list.
Columns count by it, and deviations of what is found follow from it. If it is not given, all
columns count alike, and it is estimated from the differences.

@examples[#:eval session
(define (pendulum-of g l) (Lagrangian->state-derivative (L-pendulum g 1 l)))
(define film
  (list (up 0 1.003) (up 0.3 0.701) (up 0.6 -0.008) (up 0.9 -0.704) (up 1.2 -0.993)
        (up 1.5 -0.701) (up 1.8 -0.024) (up 2.1 0.672) (up 2.4 0.994)))
(define fit
  (fit-motion pendulum-of (up 0 0.9 0) film #:parameters '((g 9.81) (l 1.0)) #:hold '(g)
              #:measured coordinate))
fit]

The method is that of Levenberg and Marquardt, with derivatives of the motion by the equations of
variations, exact but for the integration's @racket[tolerance]. The least found is that near the
first values; from others there may be another.

Data do not determine everything. Where a change of some unknowns, alone or together, changes
nothing that was measured, an error names them and nothing is returned; so it is an error if there
are fewer numbers than unknowns, a number that is not finite, a row before the start, or no least
sum of squares found after 200 steps.

@examples[#:eval session #:label #f
(eval:error (fit-motion pendulum-of (up 0 0.9 0) film #:parameters '((g 9.81) (l 1.0))
                        #:measured coordinate))]

Source: J. J. Moré, @italic{The Levenberg–Marquardt algorithm: implementation and theory}, 1978.
Values, deviations and sums of squares are tested against those that NIST certifies, and against
SciPy's @tt{least_squares}.}

@deftogether[(@defproc[(motion-fit? [x any/c]) boolean?]
              @defproc[(motion-fit-values [fit motion-fit?]) (listof (list/c symbol? real?))]
              @defproc[(motion-fit-deviations [fit motion-fit?]) (listof (list/c symbol? real?))]
              @defproc[(motion-fit-covariance [fit motion-fit?]) matrix?]
              @defproc[(motion-fit-residuals [fit motion-fit?]) (listof up?)]
              @defproc[(motion-fit-start [fit motion-fit?]) state]
              @defproc[(motion-fit-parameters [fit motion-fit?]) (listof real?)]
              @defproc[(motion-fit-chi-square [fit motion-fit?]) real?])]{

What @racket[fit-motion] found: the values with their names, their standard deviations and the
matrix of their covariances in the same order; the residuals, what was measured less what the
motion has, in tuples of the time and one for each column; the start and all parameters, also those
that were held, from which the motion is followed; and the sum of the squares, in units of the
deviations if these were given.

@examples[#:eval session
(motion-fit? fit)
(motion-fit-values fit)
(motion-fit-deviations fit)
(matrix-ref (motion-fit-covariance fit) 0 2)
(car (motion-fit-residuals fit))
(motion-fit-chi-square fit)
(define derivative (apply pendulum-of (motion-fit-parameters fit)))
((evolve-trajectory derivative (motion-fit-start fit) 3) 0.6)]

@racket[plot-point] draws residuals over time.}

@(close-session session)
