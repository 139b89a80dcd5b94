#lang scribble/manual
@(require (for-label mechanics)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "reading-certificates"]{Certificates: proofs that Coq checks}

@(define session (make-session))

@italic{Proved} rests on the algebra of this library. Whoever does not want to trust that can have a
@emph{certificate}: the claim as a theorem, with a proof, in a file for Coq. Coq is a proof
assistant: a program that accepts a proof only if each step follows from axioms by rules of logic,
and whose core is small and old. You need no Coq to write a certificate, and to read one you need
this page.

@section{From a verdict to a file}

An oscillator, and the path that one expects:

@examples[#:eval session #:label #f
(define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define swing
  (verify-solution (L-harmonic 'm (* 'm (square 'w))) (lambda (t) (* 'a (cos (* 'w t))))))
swing
(certificate swing)
(write-certificate swing (build-path (find-system-path 'temp-dir) "swing.v"))]

Where Coq is installed (on Debian @exec{apt-get install coq libcoq-coquelicot}),
@exec{coqc swing.v} checks the file. It prints the axioms that the proof rests on. Where a file
speaks of derivatives, as this one does, Coq also prints a warning about Coquelicot, its
library of derivatives, which does not concern the proof. If it printed an error, there would be no
proof.

@section{One file, line by line}

After some lemmas and tactics, which are the same in each file and are proved there as well, it goes
on like this:

@verbatim[#:indent 2]|{
Definition hypotheses (a t w m : R) : Prop :=
  True.
}|

@tt{R} is the type of the real numbers, and @tt{Prop} that of statements. Here nothing has to be
assumed, so the hypotheses are the statement that is always true. Were there a divisor m in the
path, the line would be @tt{m <> 0}, which reads: m is not zero. These lines are what you check
first, for a theorem is only as good as its hypotheses are weak.

@verbatim[#:indent 2]|{
Section motion.
Variables a w m : R.

(* The Lagrangian, of the time, the coordinates and the velocities *)
Definition L (t q v : R) : R := 1 / 2 * m * v * v - 1 / 2 * m * w * w * q * q.
(* The path and, the theorem says, its velocity *)
Definition path (t : R) : R := a * cos (w * t).
}|

Let a, w and m be real numbers. L is your Lagrangian and @tt{path} your path, as the library read
them off your procedures: compare them with your program. This is the one step in which you trust
us.

@verbatim[#:indent 2]|{
Definition velocity (t : R) : R := - a * sin (w * t) * w.
Definition momentum (t : R) : R := m * (- a * sin (w * t) * w).
Definition slope (t : R) : R := - m * w * w * (a * cos (w * t)).
}|

Three more functions. Their names are names, and say nothing yet; the theorem says what they are:

@verbatim[#:indent 2]|{
Theorem claim : forall t : R, hypotheses a t w m ->
  is_derive path t (velocity t) /\
  is_derive (fun s => L t (path t) s) (velocity t) (momentum t) /\
  is_derive (fun s => L t s (velocity t)) (path t) (slope t) /\
  is_derive momentum t (slope t).
}|

@tt{forall t : R} is: for all times t. The arrow is @italic{implies}, and @tt{/\} is @italic{and}.
@tt{is_derive f t y} says that the function f has a derivative at t, and that it is y. So the four
lines read: the path has this velocity; the derivative of L by the velocity, at the path, is the
momentum; the derivative of L by the coordinate is the slope; and the derivative of the momentum is
the slope. The last one is Lagrange's equation, @formula{d/dt ∂₂L = ∂₁L}.

Between @tt{Proof} and @tt{Qed} stand the steps of the proof. You need not read them. Whatever
stands there, Coq accepts it only if it proves the theorem.

@verbatim[#:indent 2]|{
Theorem not_vacuous : exists (a t w m : R), hypotheses a t w m.
}|

A theorem whose hypotheses contradict each other would be true, and empty. So each file proves that
there are numbers for which all of its hypotheses hold.

@verbatim[#:indent 2]|{
Definition certificate := conj claim not_vacuous.
Print Assumptions certificate.
}|

Coq is asked what both theorems rest on. It names the axioms of its real numbers; there is none of
ours, and no gap in the proof would stay unsaid.

@section{Functions that have a value everywhere}

In Coq, 1/0 is a number: it is 0. The root of −1 is 0, too, and the logarithm of a negative number
is something. So a theorem without hypotheses may be true for a reason that you do not mean, or
false where you mean it to be silent. For that the certificate names each divisor, each radicand and
each argument of a logarithm:

@examples[#:eval session #:label #f
(certificate (verify-equal (/ (- (square 'x) (square 'y)) (- 'x 'y)) (+ 'x 'y)))]

@verbatim[#:indent 2]|{
Definition hypotheses (x y : R) : Prop :=
  (* domain: each part of the claim has a value *)
  x - y <> 0.

Theorem claim : forall (x y : R),
  hypotheses x y ->
  (x * x - y * y) / (x - y) = x + y.
}|

This certificate is of the first level: the identity as it was asked. Where derivatives stand in
such an identity, they are ours, and it says so in its words.

@section{All motions}

That a quantity is conserved is said of every motion, and nobody knows these as formulas. So the
file defines what a motion is, for any functions of the time:

@examples[#:eval session #:label #f
(define L (L-harmonic 'm 'k))
(certificate (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v)))]

@verbatim[#:indent 2]|{
Definition motion (path velocity : R -> R) (t : R) : Prop :=
  is_derive path t (velocity t) /\
  ex_derive velocity t /\
  is_derive (fun s => momentum s (path s) (velocity s)) t (slope t (path t) (velocity t)).
}|

The velocity is the derivative of the path, it has one itself (@tt{ex_derive}), and Lagrange's
equation holds at the time t. Beside what @tt{momentum} and @tt{slope} are, the theorem says:

@verbatim[#:indent 2]|{
  (forall (path velocity : R -> R) (t : R),
    hypotheses k m (velocity t) (path t) t ->
    motion path velocity t ->
    is_derive (fun s => quantity s (path s) (velocity s)) t 0).
}|

And @tt{not_vacuous} proves that there is such a motion.

@section{Functions that nobody knows}

A literal function stands for any function that has derivatives; that it has them is a hypothesis:

@examples[#:eval session #:label #f
(define U (literal-function 'U (-> (X Real Real) Real)))
(define (L-plane s)
  (- (* 1/2 'm (square (velocity s))) (U (ref (coordinate s) 0) (ref (coordinate s) 1))))
(certificate (verify-conserved L-plane (Lagrangian->energy L-plane)
                               (up 't (up 'x 'y) (up 'vx 'vy))))]

Of a function of one variable it would read @tt{is_derive U x (DU x)}. Two partial derivatives say
less than one might think: a function can have both at a point and jump there. So the file says what
is meant, that the function has a rate along each path through the point that has a velocity:

@verbatim[#:indent 2]|{
Definition differentiable_2 (f : R -> R -> R) (x_1 x_2 d_1 d_2 : R) : Prop :=
  forall (p_1 p_2 : R -> R) (t v_1 v_2 : R),
    p_1 t = x_1 -> p_2 t = x_2 ->
    is_derive p_1 t v_1 -> is_derive p_2 t v_2 ->
    is_derive (fun s => f (p_1 s) (p_2 s)) t (d_1 * v_1 + d_2 * v_2).
}|

In finitely many dimensions this is total differentiability, as textbooks define it: no function
that has a derivative there is left out. The proof that the hypotheses can hold takes polynomials.

What has a certificate of which level is in the table of
@secref["reference-verdicts"].

@section{A program with many verdicts}

@commandline{raco mechanics certify program.rkt}

writes a file for each proved verdict that the program shows, on a line of its own, and tells what
Coq says. If Coq
rejects one, either our proof is wrong or our claim is; please tell us.

@next-pages["what-proved-means" "what a proof is here"
            "reference-verdicts" "what has a certificate"]

@(close-session session)
