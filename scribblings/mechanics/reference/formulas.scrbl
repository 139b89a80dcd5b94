#lang scribble/manual
@(require (for-label mechanics mechanics/pict) "../eval.rkt" "../citation.rkt")

@title[#:tag "formulas"]{Formulas}

@(define session (make-session '(require mechanics/book)))
@(define drawing (make-picture-session '(require mechanics/pict scribblings/mechanics/figure)))

Any value, and any verdict, derivation or other result, as a formula of a physics book: on
one line, in lines of text, for TeX, for pages, as a picture. @secref["guide-formulas"] tells
how they are used. None of these simplifies; @racket[simplify] does, and
@racket[print-expression].

Names are Greek where they are those of Greek letters, @racket['theta_1] having a subscript,
@racket['v^x] a superscript, @racket['thetadot] a dot. Any other characters of a name stand
as they are: nothing in it is a command of TeX or the markup of a page. A value that has no
notation, such as a procedure without a name, is shown as it prints.

@section{One line}

@defproc[(->infix [x value]) string?]{

The value, as it stands, on one line of Unicode; @racket[(->infix (simplify x))] shows what the
prompt would. Factors have spaces between them and applications none;
what stands before a slash in its product is the numerator, and one factor behind it the
denominator. A name that would be read as another one stands between bars: @racket['θ] does,
since @racket['theta] is written as the letter. In text that is not read back, as that of
@racket[->text], both are the letter.

@examples[#:eval session
(->infix (- (* 1/2 'm (square 'xdot)) (* 'm 'g 'x)))
(->infix (((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't))
(->infix (up 'theta_1 (/ (+ 'a 'b) 'c) '|two words|))
(->infix (quaternion 'a 'b 0 -1))
(define p (/ (+ 'a 'a) (* 'm 'r 'r)))
(list (->infix p) (->infix (simplify p)))]}

@defproc[(read-infix [text string?]) value]{

The value of a formula written as @racket[->infix] writes it: what it writes of an expression is
read as an expression of the same value, with the same names. Tuples, matrices, relations,
quaternions and power series of finitely many terms are read, too, and of programs the signs
@tt{*} and @tt{**}, a minus sign behind them, numbers such as @tt{1e-3} and the name @tt{pi}; but
@tt{x^2} is a name with a superscript, as a component of a literal tuple has it. A series of terms
that are no powers looks like their sum and is read as that; the terms that @litchar{⋯} stands for
are not on the line. Such text, and other text that is no formula, is an error that tells the
position.

@examples[#:eval session
(read-infix "½ m ẋ² − m g x")
(read-infix "m D²x(t) + k x(t)")
(read-infix "x ↦ 1 + x + ½ x²")
(read-infix "1/2*m*v**2 - m*g*x")
(read-infix "2*pi*sqrt(l/g)")
(eval:error (read-infix "m (a + "))]}

@section{Text, TeX, pages}

Each of these breaks long formulas at their signs where they are wider than
@racket[width] columns of text; @racket[#f] leaves them whole. A width that is not a positive
number is an error.

@defproc[(->text [x value] [#:width width (or/c exact-positive-integer? #f) 80]) string?]{

The value, as it stands, in lines of text, with fractions, roots and brackets drawn;
@racket[simplify] it first to see what the prompt shows.

@examples[#:eval session
(display (->text (/ (+ 'a (/ 'b 'c)) (sqrt (+ 1 (square 'x))))))
(display (->text (up 't (up 'x 'y) (down 'p_x 'p_y))))
(display (->text (expand (expt (+ 'a 'b) 7)) #:width 40))]}

@defproc[(->TeX [x value] [#:width width (or/c exact-positive-integer? #f) 80]) string?]{

The value, as it stands, for LaTeX's mathematics mode, between @tt{\[} and @tt{\]} for
instance, with the package @tt{amsmath}; @racket[simplify] it first to write what the prompt
shows. It uses nothing that pdfLaTeX lacks.

@examples[#:eval session
(->TeX (simplify (/ 'p_phi (* 'm (square 'r)))))
(->TeX (/ 'p_phi (* 'm (square 'r))))
(->TeX (((expt D 2) (literal-function 'theta)) 't))
(->TeX '|\input{file}|)]}

@defproc[(->MathML [x value] [#:width width (or/c exact-positive-integer? #f) 80]
                   [#:inline? inline? any/c #f])
         string?]{

The value, as it stands, as presentation MathML, which browsers show without any script; on a
line of its own, or within a text if @racket[inline?]. @racket[simplify] it first to show what
the prompt does.

@examples[#:eval session
(->MathML (sqrt 'x))
(->MathML 'theta_1 #:inline? #t)]}

@section{Choices}

@defparam[derivative-style style (or/c 'automatic 'dots 'D)]{

How derivatives of functions of one variable are marked: by dots, up to three, or by D.
@racket['automatic], as it is to begin with, takes dots for functions of @racket['t] where
formulas are drawn, and D on one line and for other variables.

@examples[#:eval session
(define v ((D (literal-function 'x)) 't))
(list (->infix v) (->TeX v))
(parameterize ([derivative-style 'D]) (->TeX v))]}

@defparam[suppress-arguments names (listof symbol?)]{

The symbols that are not shown as arguments: a literal function applied to these alone stands
without them. None to begin with.

@examples[#:eval session
(parameterize ([suppress-arguments '(t)])
  (->infix (* 'm (((expt D 2) (literal-function 'x)) 't))))]}

@section{Pictures of formulas}

@defmodule[mechanics/pict #:packages ("mechanics")]

@defproc[(->pict [x value] [#:size size real? 16]
                 [#:width width (or/c exact-positive-integer? #f) 80]
                 [#:color color any/c #f])
         pict?]{

The value as a pict of the library @racketmodname[pict #:indirect], which is loaded for the
first one: letters of this size, in this color or that of the text around. Its base line is
at its descent, so that it stands level in a line of text.

@picture-examples[drawing
(eval:alts (->pict (/ (square 'thetadot) (sqrt (+ 1 'x))) #:size 20)
           (figure (->pict (/ (square 'thetadot) (sqrt (+ 1 'x))) #:size 20)))]}

@(close-session session)
@(close-session drawing)
