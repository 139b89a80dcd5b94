#lang racket/base
;; Certificates as they are written, for which Coq need not be there: the statement in the user's
;; names, assumptions and domain as hypotheses, what has none and why, and what is no verdict.

(require racket/file racket/string
         mechanics mechanics/book
         (only-in mechanics/certificate/certificate certificate-gap certificate-level
                  certificate-or-reason certificate-text certificate?)
         "../support/checks.rkt" "../support/messages.rkt"
         "../support/certification/certificate-parts.rkt"
         "../support/certification/false-neighbours.rkt"
         "../support/certification/proved-claims.rkt")

(test-case "a certificate prints as its theorem in words"
  (check-equal? (format "~a" (certificate (verify-equal (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x)))))
                (string-append "a theorem for Coq to check: both sides are equal; "
                               "the derivatives are ours"))
  (check-equal? (format "~s" (certificate (verify-equal (/ 'x (sqrt 'x)) (sqrt 'x))))
                (string-append "a theorem for Coq to check: both sides are equal "
                               "under 0 <= x, sqrt x <> 0; the derivatives are ours"))
  (check-equal? (format "~a" (certificate (verify-solution (L-free-particle 'm) (lambda (t) 'c))))
                (string-append "a theorem for Coq to check: the path is a motion "
                               "of the Lagrangian; by Coq's own derivatives")))

(test-case "what a function of the user raises while a certificate is written is raised"
  (define raises? #f)
  (define (L local) (if raises? (raise 'boo) ((L-free-particle 'm) local)))
  (define v (verify-solution L (lambda (t) 'c)))
  (set! raises? #t)
  (check-exn symbol? (lambda () (certificate v))))

(test-case "nothing is simplified: each divisor and each radicand is a hypothesis"
  (check-equal? (statement (verify-equal (/ (- (square 'x) (square 'y)) (- 'x 'y)) (+ 'x 'y)))
                (string-append
                 "Definition hypotheses (x y : R) : Prop := "
                 "(* domain: each part of the claim has a value *) x - y <> 0. "
                 "Theorem claim : forall (x y : R), hypotheses x y -> "
                 "(x * x - y * y) / (x - y) = x + y."))
  (check-equal? (statement (verify-equal (square (sqrt 'x)) 'x))
                (string-append
                 "Definition hypotheses (x : R) : Prop := "
                 "(* domain: each part of the claim has a value *) 0 <= x. "
                 "Theorem claim : forall (x : R), hypotheses x -> sqrt x * sqrt x = x.")))

(test-case "an example of hypotheses is proved one by one, each with those before"
  (define v (verify-equal (+ (/ 1 'x) (/ 1 'y) (log 'z)) (+ (log 'z) (/ 1 'y) (/ 1 'x))))
  (define (taken k) (format "  apply and_later. { at_numbers. } intro given_~a.\n" k))
  (check-true (string-contains? (certificate-text (certificate v))
                                (string-append (taken 1) (taken 2) "  at_numbers.\nQed."))))

(test-case "what is assumed is a hypothesis of its own"
  (check-regexp-match
   (regexp-quote (string-append ":= (* assumed *) 0 < x /\\ "
                                "(* domain: each part of the claim has a value *) 0 <= x * x."))
   (statement (assuming ('(> x 0)) (verify-equal (sqrt (square 'x)) 'x)))))

(test-case "names: the user's, but for words of Coq; derivatives of unknown functions"
  (define f (literal-function 'f))
  (check-regexp-match (regexp-quote (string-append "forall (R_ alpha : R), hypotheses R_ alpha -> "
                                                   "alpha * R_ = 2 * R_ * alpha - "))
                      (statement (verify-equal (* 'α 'R) (- (* 2 'R 'α) (* 'α 'R)))))
  (check-regexp-match #rx"\\(x : R\\) \\(f : R -> R\\) \\(Df : R -> R\\) : Prop"
                      (statement (verify-equal ((D (square f)) 'x) (* 2 (f 'x) ((D f) 'x))))))

(test-case "names: the user's give way to those that the file defines, and to Coq's constants"
  (define (sum-of-two a b) (statement (verify-equal (square (+ a b)) (square (+ b a)))))
  (for ([name (in-list '(hypotheses claim given given_1 kernel_2 True False positive half_root))])
    (check-regexp-match (format "forall \\(.*~a_.* : R\\)" name)
                        (sum-of-two name 'x)
                        (format "~a" name)))
  (define text
    (statement (verify-solution (L-harmonic 'L 'path)
                                (lambda (t) (* 'velocity (cos (* (sqrt (/ 'path 'L)) t)))))))
  (check-regexp-match #rx"Variables (L_|path_|velocity_) (L_|path_|velocity_) " text)
  (check-regexp-match #rx"Definition path \\(t : R\\) : R := velocity_ \\* cos" text)
  (define (energy-with m)
    (define L (L-harmonic m 'k))
    (statement (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v))))
  (for ([name (in-list '(ex_derive is_derive Derive I))])
    (check-regexp-match (format "Variables (k )?~a_[ .]" name) (energy-with name))))

(test-case "a motion: Lagrangian and path are functions, the equations derivatives of Coq"
  (define text
    (statement (verify-solution (L-harmonic 'm (* 'm (square 'w)))
                                (lambda (t) (* 'a (cos (* 'w t)))))))
  (check-regexp-match #rx"Definition path \\(t : R\\) : R := a \\* cos \\(w \\* t\\)[.]" text)
  (check-regexp-match #rx"Definition L \\(t q v : R\\) : R := 1 / 2 \\* m \\* v \\* v - " text)
  (check-regexp-match
   (regexp-quote
    (string-append "is_derive path t (velocity t) /\\ "
                   "is_derive (fun s => L t (path t) s) (velocity t) (momentum t) /\\ "
                   "is_derive (fun s => L t s (velocity t)) (path t) (slope t) /\\ "
                   "is_derive momentum t (slope t)."))
   text))

(define ((L-falling m g) local)
  (- (* 1/2 m (square (velocity local))) (* m g (coordinate local))))

(test-case "a conserved quantity: of every motion, whose equations are hypotheses"
  (define L (L-falling 'm 'g))
  (define v (verify-conserved L (Lagrangian->energy L) (up 't 'z 'zdot)))
  (check-true (string-contains? (certificate-text (certificate v)) "(* The quantity *)"))
  (define text (statement v))
  (check-regexp-match #rx"Definition slope [(]t z zdot : R[)] : R := - m [*] g[.]" text)
  (check-regexp-match
   (regexp-quote
    (string-append
     "Definition motion (path velocity : R -> R) (t : R) : Prop := "
     "is_derive path t (velocity t) /\\ ex_derive velocity t /\\ "
     "is_derive (fun s => momentum s (path s) (velocity s)) t "
     "(slope t (path t) (velocity t))."))
   text)
  (check-regexp-match
   (regexp-quote
    (string-append
     "(forall t z zdot : R, hypotheses g m z zdot t -> "
     "is_derive (fun s => L t z s) zdot (momentum t z zdot) /\\ "
     "is_derive (fun s => L t s zdot) z (slope t z zdot)) /\\ "
     "(forall (path velocity : R -> R) (t : R), "
     "hypotheses g m (path t) (velocity t) t -> motion path velocity t -> "
     "is_derive (fun s => quantity s (path s) (velocity s)) t 0)."))
   text))

;; V = log (z - 3): a state may have z > 3 alone.
(test-case "a conserved quantity: of a state at numbers, and kernels along the path as at the state"
  (define (L local)
    (- (* 1/2 'm (square (velocity local))) (log (- (coordinate local) 3))))
  (define through
    (regexp-match #rx"path_through [(]([0-9]+)[)]"
                  (file-of (verify-conserved L (Lagrangian->energy L) (up 't 'z 'zdot)))))
  (check-true (> (string->number (cadr through)) 3))
  (define pendulum (L-pendulum 'g 'm 'l))
  (define of-pendulum
    (verify-conserved pendulum (Lagrangian->energy pendulum) (up 't 'theta 'v)))
  (has "(kernel_1 : sin theta * sin theta = 1 - cos theta * cos theta)" of-pendulum)
  (has "(kernel_1 : sin (path t) * sin (path t) = 1 - cos (path t) * cos (path t))" of-pendulum))

(test-case "what a proof rests on: laws of exponentials, arcs and logarithms, factors of divisors"
  (assuming ('(> x 0) '(> y 0))
    (has "(exp (1 / 2 * ln x)) ^ 2 = x). { apply exp_part_2; [positive | field]. }"
         (verify-equal (square (exp (* 1/2 (log 'x)))) 'x))
    (has "atan (1 / x) = 1 / 2 * PI - atan x). { replace (1 / x) with (/ x); [rewrite atan_inv by"
         (verify-equal (+ (atan 'x) (atan (/ 1 'x))) (/ ':pi 2)))
    (has "ln (x * y) = ln x + ln y). { replace (x * y) with ((x) * (y)); [logarithms |"
         (verify-equal (log (* 'x 'y)) (+ (log 'x) (log 'y)))))
  (define of-arc (verify-equal (* 'y (cos (atan 'x))) (/ 'y (sqrt (+ 1 (square 'x))))))
  (has "sin (atan x) = x / sqrt (1 + x * x)). { apply sin_atan; bounds. }" of-arc)
  (has "cos (atan x) = 1 / sqrt (1 + x * x)). { apply cos_atan; bounds. }" of-arc)
  (for ([(arc name other) (in-parallel (list asin acos) '("asin" "acos") '("cos" "sin"))]
        [of-arc (list cos sin)])
    (has (format "~a (~a x) = sqrt (1 - x * x)). { apply ~a_~a; bounds. }" other name other name)
         (verify-equal (* 'y (of-arc (arc 'x))) (* 'y (sqrt (- 1 (square 'x)))))))
  (has "acos x = 1 / 2 * PI - asin x). { rewrite acos_asin by"
       (verify-equal (+ (asin 'x) (acos 'x)) (/ ':pi 2)))
  (has "Rabs (x * y) = Rabs x * Rabs y). { apply modulus_is;"
       (verify-equal (abs (* 'x 'y)) (* (abs 'x) (abs 'y))))
  (define of-symbolic-power (verify-equal (square (sqrt (expt 'x 'y))) (expt 'x 'y)))
  (has "= Rpower x y). { apply sqrt_sqrt; left; apply exp_pos. }" of-symbolic-power)
  (define of-exponentials (verify-equal (exp (* 2 'x)) (* (exp (- 'x 'y)) (exp (+ 'x 'y)))))
  (has "exp (2 * x) = (exp x) ^ 2)" of-exponentials)
  (define of-square (verify-equal (/ 1 (+ (square 'x) (* 2 'x 'y) (square 'y)))
                                  (/ 1 (square (+ 'x 'y)))))
  (has "= (x + y) ^ 2) by ((first [reflexivity | ring |" of-square)
  (has "x + y <> 0) by (let Z := fresh in let G := fresh in intro Z;" of-square))

(test-case "parts of a turn are known where a theorem has some, and are not asked for elsewhere"
  (define of-eighth
    (verify-equal (sin (+ 'x (/ ':pi 4))) (/ (+ (sin 'x) (cos 'x)) (sqrt 2))))
  (has "sin (1 / 4 * PI) = 1 / 2 * sqrt 2). { turn_4. }" of-eighth)
  (has "cos (1 / 4 * PI) = 1 / 2 * sqrt 2). { turn_4. }" of-eighth)
  (check-false (regexp-match? #rx"turn_[0-9][.] }"
                              (file-of (verify-equal (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x)))))))

(test-case "a canonical transformation: the derivatives, and all brackets of these"
  (define (turned state)
    (up (time state) (momentum state) (- (coordinate state))))
  (check-regexp-match
   (regexp-quote (string-append "D1_coordinate t q p * D2_momentum t q p - "
                                "D2_coordinate t q p * D1_momentum t q p = 1"))
   (statement (verify-canonical turned (up 't 'q 'p))))
  (define text (certificate-text (certificate (verify-canonical turned (up 't 'q 'p)))))
  (for ([name '(D1_coordinate D2_coordinate D1_momentum D2_momentum)] [value '("0" "1" "- 1" "0")])
    (check-true (string-contains? text (format "Definition ~a (t q p : R) : R := ~a." name value))))
  ;; derivatives that are roots
  (define (stretched state)
    (up (time state) (* (sqrt 2) (coordinate state)) (/ (momentum state) (sqrt 2))))
  (check-regexp-match #rx"Definition D1_coordinate .* := sqrt 2[.]"
                      (statement (verify-canonical stretched (up 't 'q 'p)))))

(test-case "constraints: they hold along the path, and multipliers make their forces"
  (define (L local) (* 1/2 'm (square (velocity local))))
  (define (circle t) (up (* 'l (cos (* 'w t))) (* 'l (sin (* 'w t)))))
  (define text
    (statement (verify-solution L circle
                                #:constraints (holonomic (lambda (t q) (- (square q) (* 'l 'l)))))))
  (check-regexp-match
   (regexp-quote "is_derive momentum_0 t (slope_0 t + multiplier t * normal_0 t)") text)
  (check-regexp-match
   (regexp-quote "constraint t (path_0 t) (path_1 t) (velocity_0 t) (velocity_1 t) = 0") text)
  ;; m g hangs on a string of the length l: 0 = - m g - 2 l λ
  (define (heavy local) (- (L local) (* 'm 'g (ref (coordinate local) 1))))
  (has "Definition multiplier (t : R) : R := (- 1 / 2 * g * m) / l."
       (verify-solution heavy (lambda (t) (up 0 (- 'l)))
                        #:constraints (holonomic (lambda (t q) (- (square q) (* 'l 'l)))))))

(test-case "where a force has a value is a hypothesis, too"
  (define (free local) (* 1/2 'm (square (velocity local))))
  (has "2 * m <> 0 /\\ a - b <> 0."
       (verify-solution free (lambda (t) (/ (* (+ 'a 'b) t t) (* 2 'm)))
                        #:force (lambda (s) (/ (- (square 'a) (square 'b)) (- 'a 'b))))))

(test-case "words: a force and constraints are named, where there are any"
  (define (free local) (* 1/2 'm (square (velocity local))))
  (define (drag local) (* -1 'c (velocity local)))
  (define (carried #:force [force #f] #:constraints [constraints #f] path)
    (format "~a" (certificate (verify-solution free path #:force force
                                               #:constraints constraints))))
  (define resting (holonomic (lambda (t x) x)))
  (define fading (lambda (t) (exp (* -1 (/ 'c 'm) t))))
  (check-equal? (carried fading #:force drag)
                (string-append "a theorem for Coq to check: the path is a motion of the Lagrangian "
                               "with the force under m <> 0; by Coq's own derivatives"))
  (check-regexp-match #rx"of the Lagrangian with the constraints;"
                      (carried (lambda (t) 0) #:constraints resting))
  (check-regexp-match #rx"of the Lagrangian with the force and the constraints;"
                      (carried (lambda (t) 0) #:force drag #:constraints resting))
  (define (slowing local) (+ (* 'm (velocity local)) (* 'c (coordinate local))))
  (check-regexp-match
   #rx"conserved along the motions of the Lagrangian with the force(;| under)"
   (format "~a" (certificate (verify-conserved free slowing (up 't 'x 'v) #:force drag)))))

(test-case "hypotheses: x <> 0 is none where the sign of x is one"
  (define swing
    (assuming ('(> m 0))
      (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'a (cos (* (sqrt (/ 'k 'm)) t)))))))
  (check-regexp-match #rx" under 0 < m, 0 < k / m;" (format "~a" (certificate swing)))
  (check-false (regexp-match? #rx"m <> 0," (statement swing)))
  (check-regexp-match
   #rx" under y < 0, 0 <= y [*] y;"
   (format "~a" (assuming ('(< y 0)) (certificate (verify-equal (/ (sqrt (square 'y)) 'y) -1))))))

(test-case "a literal function has its derivatives as hypotheses, where the claim speaks of it"
  (define L (lambda (s) (- (* 1/2 'm (square (velocity s)))
                           ((literal-function 'V) (coordinate s)))))
  (define v (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v)))
  (check-regexp-match (regexp-quote "is_derive V x (DV x)") (statement v))
  (check-equal? (certificate-level (certificate v)) 2)
  (check-regexp-match (regexp-quote "(fun s => 1 + 1 * s)") (certificate-text (certificate v))))

(test-case "a parameter that is called t is not the time"
  (define named-t (string->symbol "t"))
  (define swing
    (verify-solution (L-harmonic 'm 'k)
                     (lambda (time) (* named-t (cos (* (sqrt (/ 'k 'm)) time))))))
  (check-equal? (certificate-level (certificate swing)) 2)
  (check-regexp-match
   (regexp-quote "Definition path (time : R) : R := t * cos (sqrt (k / m) * time).")
   (statement swing))
  (define of-positive
    (assuming ('(> t 0))
      (certificate
       (verify-solution (L-harmonic 'm 'k)
                        (lambda (time) (* (- (sqrt (square named-t)) named-t) (square time)))))))
  (check-equal? (certificate-gap of-positive)
                "the symbol t is a parameter, and assumptions may mean it or the time"))

(test-case "of several variables, it is differentiable along each path"
  (define V (literal-function 'V (-> (X Real Real) Real)))
  (define (L s)
    (- (* 1/2 'm (square (velocity s))) (V (ref (coordinate s) 0) (ref (coordinate s) 1))))
  (define text
    (certificate-text (certificate (verify-conserved L (Lagrangian->energy L)
                                                     (up 't (up 'x 'y) (up 'vx 'vy))))))
  (define (has part) (check-regexp-match (regexp-quote part) (string-normalize-spaces text)))
  (has (string-append
        "Definition differentiable_2 (f : R -> R -> R) (x_1 x_2 d_1 d_2 : R) : Prop := "
        "forall (p_1 p_2 : R -> R) (t v_1 v_2 : R), p_1 t = x_1 -> p_2 t = x_2 -> "
        "is_derive p_1 t v_1 -> is_derive p_2 t v_2 -> "
        "is_derive (fun s => f (p_1 s) (p_2 s)) t (d_1 * v_1 + d_2 * v_2)."))
  (has "differentiable_2 V x y (D0_V x y) (D1_V x y).")
  (has (string-append "exists (1), (1), "
                      "(fun s_1 s_2 => 1 + 1 * (s_1 + s_2) + 2 + 2 * s_1 + 1 + 1 * s_2), "
                      "(fun _ _ => 3), (fun _ _ => 2),")))

(test-case "derivatives of a function of tuples are named by their places"
  (define H (make-Hamiltonian (literal-function 'H (Hamiltonian 2))))
  (check-regexp-match
   (regexp-quote (string-append "differentiable_5 H_ t x y px py (D0_H t x y px py) "
                                "(D1_0_H t x y px py) (D1_1_H t x y px py) "
                                "(D2_0_H t x y px py) (D2_1_H t x y px py)"))
   (statement (verify-conserved H (lambda (s) 1) (up 't (up 'x 'y) (down 'px 'py))))))

(test-case "a motion of a Hamiltonian: coordinates, momenta and Hamilton's equations"
  (define (H s) (+ (/ (square (momentum s)) (* 2 'm)) (* 1/2 'k (square (coordinate s)))))
  (define w (sqrt (/ 'k 'm)))
  (define v
    (verify-Hamiltonian-solution H (lambda (t) (* 'a (cos (* w t))))
                                 (lambda (t) (* -1 'm w 'a (sin (* w t))))))
  (check-regexp-match #rx"the path is a motion of the Hamiltonian under"
                      (format "~a" (certificate v)))
  (check-regexp-match
   (regexp-quote
    (string-append "is_derive coordinate t (rate t) /\\ "
                   "is_derive (fun s => H t (coordinate t) s) (momentum t) (rate t) /\\ "
                   "is_derive (fun s => H t s (momentum t)) (coordinate t) (slope t) /\\ "
                   "is_derive momentum t (- slope t)."))
   (statement v)))

(test-case "a question of level 2 that has a certificate of level 1 only knows why"
  (define c
    (certificate (verify-solution (L-harmonic 1 2) (lambda (t) (cos (* 1.4142135623730951 t))))))
  (check-equal? (certificate-level c) 1)
  (check-equal? (certificate-gap c) "the procedures hold the decimals themselves"))

(test-case "every file shows that its hypotheses hold together, and what it rests on"
  (define text (certificate-text (certificate (verify-equal (/ (square 'x) 'x) 'x))))
  (check-regexp-match #rx"Theorem not_vacuous : exists \\(x : R\\), hypotheses x[.]" text)
  (check-regexp-match #rx":= conj claim not_vacuous[.]\nPrint Assumptions certificate[.]" text)
  (check-false (regexp-match? #rx"Admitted|Axiom|Parameter" text)))

(test-case "decimals that the proof reads as exact numbers are these in the claim, and it says so"
  (define c (certificate (verify-equal (sin (+ 'x (* 2 pi))) (sin 'x))))
  (check-regexp-match #rx"reading 6.283185307179586 as \\(\\* 2 :pi\\)$" (format "~a" c))
  (check-regexp-match
   (regexp-quote "(* Decimals are read as exact numbers: 6.283185307179586 as 2 * PI *)")
   (certificate-text c))
  (define swing
    (verify-solution (L-harmonic 1 2) (lambda (t) (cos (* 1.4142135623730951 t)))))
  (check-equal? (certificate-level (certificate swing)) 1)
  (check-regexp-match (regexp-quote "1.4142135623730951 as (sqrt 2)")
                      (format "~a" (certificate swing)))
  (check-false (regexp-match? #rx"14142135623730951 /" (certificate-text (certificate swing)))))

(test-case "false neighbours of a gauge and of a transformation lack a derivative"
  (define all (neighbours-by-hypotheses (proved-claims '(gauge-of-unknown moving-frame))))
  (define lacking
    (filter (lambda (n) (regexp-match? #rx": dropped hypothesis$" (neighbour-kind n))) all))
  (check-equal? (map neighbour-kind lacking)
                '("gauge: dropped hypothesis" "canonical: dropped hypothesis"))
  (for ([n (in-list lacking)])
    (define hypotheses
      (cadr (regexp-match #rx"Definition hypotheses(.*?)Section" (neighbour-text n))))
    (check-false (regexp-match? #rx"differentiable|is_derive" hypotheses) (neighbour-name n))))

(test-case "what has no certificate says why"
  (define v (verify-equal (* 2 (acosh 'x)) (+ (acosh 'x) (acosh 'x))))
  (check-equal? (certificate-or-reason v) "Coq's library has no acosh")
  (check-message "certificate: no certificate yet: Coq's library has no acosh" (certificate v)))

(test-case "sides that arithmetic makes the same say so"
  (check-equal? (format "~a" (certificate (verify-equal (+ 'a 'b) (+ 'b 'a))))
                (string-append "a theorem for Coq to check: both sides are one and the same "
                               "expression; the derivatives are ours"))
  (check-regexp-match #rx": both sides are one and the same expression"
                      (format "~a" (certificate (verify-equal (sqrt (+ 3 (* 2 (sqrt 2))))
                                                              (+ 1 (sqrt 2))))))
  (check-regexp-match #rx": an expression, less one and the same expression, is zero"
                      (format "~a" (certificate (prove-zero (- (* (sqrt 2.0) 'x)
                                                               (* (sqrt 2) 'x))))))
  (check-regexp-match #rx"both sides are equal;"
                      (format "~a" (certificate
                                    (verify-equal (up 'a (+ 'x 'x)) (up 'a (* 2 'x)))))))

(test-case "the angle of a point on the right is an arc tangent of one argument"
  (define v (assuming ('(> x 0)) (verify-equal (atan 'y 'x) (atan (/ 'y 'x)))))
  (check-regexp-match #rx"atan2 y x = atan [(]y / x[)]" (certificate-text (certificate v)))
  (check-regexp-match #rx"unfold atan2; destruct Rlt_dec" (certificate-text (certificate v))))

(test-case "the angle of a point is defined where a line ends after its name, too"
  (for ([n '(1 95)])
    (define y (string->symbol (make-string n #\y)))
    (check-regexp-match
     "\nDefinition atan2 "
     (certificate-text
      (certificate (verify-equal (* (sqrt (+ (square 'x) (square y))) (cos (atan y 'x))) 'x))))))

(test-case "a file is written for a verdict, or for its certificate"
  (define file (make-temporary-file "certificate~a.v"))
  (define v (verify-equal (+ 'x 'x) (* 2 'x)))
  (write-certificate v file)
  (check-equal? (file->string file) (certificate-text (certificate v)))
  (write-certificate (certificate v) file)
  (check-equal? (file->string file) (certificate-text (certificate v)))
  (delete-file file))

(define sum (verify-equal (+ 'x 'x) (* 2 'x)))

(define (bad-name file)
  (format (string-append "write-certificate: expected a file name as coqc takes it, "
                         "a letter, then letters, digits and _, then .v\n  given: ~s, a string")
          file))

(test-case "the name of a file is one that coqc takes, in a folder that is there"
  (for ([file (in-list '("swing" "my-proof.v" "my proof.v" "1swing.v" "swing.v/" "swing.txt"))])
    (check-message (bad-name file) (write-certificate sum file)))
  (check-regexp-match #rx"^write-certificate: there is no such folder\n  file: nowhere/swing[.]v"
                      (message-of (write-certificate sum "nowhere/swing.v") exn:fail?)))

(test-case "an identity of numbers that arithmetic settles has nothing to state"
  (check-equal? (certificate-or-reason (verify-symplectic (matrix-by-rows '(1 0) '(0 1))))
                "arithmetic makes 0 of it while it is formed, and no equation is left to state"))

(test-case "a divisor within a hyperbolic function does not stand in its logarithm's way"
  (define (rate t) (* t (sqrt (/ 'k 'm))))
  (check-pred certificate?
              (certificate-or-reason
               (assuming ('(> m 0) '(> k 0))
                 (verify-equal (log (square (cosh (rate 't)))) (* 2 (log (cosh (rate 't)))))))))

(says
 [(certificate)
  "certificate: takes 1 argument; it was given none"]
 [(certificate sum #:level 2)
  "certificate: there is no keyword #:level here"]
 [(write-certificate sum)
  "write-certificate: takes 2 arguments; it was given 1"]
 [(certificate 'x)
  "certificate: expected a verdict, such as verify-solution or verify-equal gives\n"
  "  given: the symbol x"]
 [(certificate (verify-equal 'x 'y))
  "certificate: only what is proved has a certificate\n  verdict: refuted"]
 [(write-certificate (verify-equal 'x 'y) "wrong.v")
  "write-certificate: only what is proved has a certificate\n  verdict: refuted"]
 [(write-certificate "swing.v" sum)
  "write-certificate: the verdict comes first, then the name of the file; these look swapped"]
 [(write-certificate sum 'swing)
  "write-certificate: expected the name of a file\n  given: the symbol swing"]
 [(write-certificate 'x "swing.v")
  "write-certificate: expected a verdict, such as verify-solution or verify-equal gives\n"
  "  given: the symbol x"])
