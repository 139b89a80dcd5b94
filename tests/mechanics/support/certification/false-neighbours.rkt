#lang racket/base
;; False neighbours of true claims, with the proofs that the certificates of the true ones would
;; have: a sign, a factor or an exponent is changed, a term is left out, and the library finds a
;; point where the changed claim does not hold. Or hypotheses: one that is needed is dropped, or
;; they contradict each other. Coq has to reject them all.

(require racket/list racket/string
         mechanics/algebra/expression/expression mechanics/algebra/expression/nodes
         mechanics/algebra/expression/operation
         mechanics/algebra/zero/zero-test
         mechanics/certificate/certificate
         mechanics/certificate/Coq-term mechanics/certificate/identity-theorem
         mechanics/generic/describe
         mechanics/verdict/verdict
         "harvest.rkt" "proved-claims.rkt")

(provide all-neighbours false-neighbours neighbours-by-hypotheses neighbours-by-definitions
         (struct-out neighbour))

;; name, kind : strings; text : of the file
(struct neighbour (name kind text) #:authentic)

;; Of all claims, at most `most` changes of each
(define (all-neighbours claims most)
  (append (false-neighbours claims most)
          (neighbours-by-hypotheses claims)
          (neighbours-by-definitions claims most)))

;; ---------------------------------------------------------------------------
;; Changed claims

;; At most `most` of each claim, seeded
(define (false-neighbours claims most)
  (for*/list ([c (in-list claims)] [n (in-list (neighbours-of c most))]) n))

(define (neighbours-of c most)
  (define cl (verdict-claim (asked-verdict c)))
  (define es
    (filter (lambda (e) (and (node? e) (< (length (nodes-in e)) 200))) (leaves (claim-value cl))))
  (define changed
    (for*/list ([e (in-list es)] [n (in-list (nodes-in e))] [other (in-list (variants n))])
      (put e n other)))
  (define assumed (verdict-assumptions (asked-verdict c)))
  (define false
    (for/fold ([found '()]) ([e (in-list (in-some-order (remove-duplicates changed)))]
                             #:break (= (length found) most))
      (define text (and (refuted-at-a-point? e) (certificate-of e assumed)))
      (if text (cons text found) found)))
  (for/list ([text (in-list (reverse false))] [k (in-naturals 1)])
    (neighbour (format "~a, changed ~a" (asked-name c) k) (kind-of c "changed claim") text)))

(define (in-some-order xs)
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed 1)
    (shuffle xs)))

;; Nodes that a slip would write for n
(define (variants n)
  (define args (node-args n))
  (define head (node-head n))
  (append
   (cond [(memq head (list op:+ op:*)) (without-one head args)]
         [(eq? head op:-) (list (make-node op:+ args))]
         [(eq? head op:sin) (list (make-node op:cos args))]
         [(eq? head op:cos) (list (make-node op:sin args))]
         [(and (eq? head op:expt) (exact-integer? (cadr args)))
          (list (make-node op:expt (list (car args) (+ 1 (cadr args)))))]
         [else '()])
   (for/list ([a (in-list args)] [i (in-naturals)]
              #:when (and (number? a) (not (eq? head op:expt))))
     (make-node head (list-set args i (+ a 1))))))

(define (without-one head args)
  (for/list ([a (in-list args)])
    (define others (remq a args))
    (if (= 1 (length others)) (car others) (make-node head others))))

(define (put e n other)
  (node-fold e values
             (lambda (m parts)
               (if (eq? m n) other (make-node (node-head m) parts)))))

(define (refuted-at-a-point? e) (eq? 'refuted (zero-test-status (zero-test e))))

;; -> the text, or #f where none can be written
(define (certificate-of e assumed)
  (with-handlers ([no-certificate? (lambda (_) #f)])
    (theorem-file (identity-theorem (list (cons e 0)) '() assumed))))

;; ---------------------------------------------------------------------------
;; Changed hypotheses

;; Each with one of those that it needs less, of which the file ends with its claim, and with one
;; more that contradicts what there is, with the step that would prove it of the example.
(define (neighbours-by-hypotheses claims)
  (for*/list ([needed (in-list with-needed)]
              [c (in-list claims)] #:when (eq? (asked-name c) (car needed))
              [text (in-value (certificate-text (certificate-or-reason (asked-verdict c))))]
              [n (in-list
                  (append (for/list ([k (in-list (cdr needed))])
                            (list (format "without hypothesis ~a" k) "dropped hypothesis"
                                  (without-hypothesis text k)))
                          (for/list ([more (in-list (contradictions text))])
                            (list (car more) (car more)
                                  (with-hypothesis text (cadr more))))))])
    (neighbour (format "~a, ~a" (asked-name c) (car n)) (kind-of c (cadr n)) (caddr n))))

;; Names, and places of hypotheses without which they are false: with Coq's total functions
;; x^a x^b = x^(a + b) holds for negative x as well, and others imply some.
(define with-needed
  '((square-root 1) (exponential-of-logarithm 1) (quotient 1) (geometric 1) (cube-root 1)
    (tangent-of-an-angle 2) (root-of-a-power 2) (fall-in-decimals)
    (oscillator 2) (damped-oscillator 2) (two-modes 2) (driven 1) (constant-force 1)
    (conical-pendulum 2) (tension) (circle-on-a-string)
    (energy) (energy-in-any-potential 1) (central-energy 1) (central-angular-momentum 1)
    (rectangular-angular-momentum 2) (Hamiltonian-energy 1) (friction-and-energy)
    (polar-coordinates 1) (polar-transformation) (turned-phase-space) (shear) (shear-by-any 1)
    (force-on-an-unknown-path 1 2) (gauge-of-unknown 1) (moving-frame 1)))

(define (contradictions text)
  (define derivative
    (regexp-match #px"is_derive (\\w+) (\\w+) \\((\\w+ \\w+)\\)" (hypotheses-of text)))
  (append '(("contradiction" "1 < 0") ("empty domain" "(forall x : R, 0 <= - 1 - x * x)"))
          (if derivative
              (list (list "two derivatives"
                          (apply format "is_derive ~a ~a (1 + ~a)" (cdr derivative))))
              '())))

(define (kind-of c change)
  (define kind (claim-kind (asked-verdict c)))
  (format "~a: ~a" kind change))

(define hypotheses-part #px"(Definition hypotheses[^=]*:=\n)(.*?)(\\.\n\n)")
(define (hypotheses-of text) (caddr (regexp-match hypotheses-part text)))

;; The pattern that takes the hypotheses apart, after `intros`
(define given #px"\\(given_1( & given_[0-9]+)*\\)|\\bgiven_1\\b|\\bgiven\\b")
(define (with-patterns text change)
  (regexp-replace* #px"(?m:intros [^.]*)" text
                   (lambda (line) (regexp-replace given line (lambda (p . _) (change p))))))

(define (with-hypothesis text more)
  (define changed
    (regexp-replace hypotheses-part text
                    (lambda (_ before body after)
                      (string-append before "  " more " /\\\n" body after))))
  (string-replace (with-patterns changed (lambda (p) (format "(given_0 & ~a)" p)))
                  "unfold hypotheses. cbv beta.\n"
                  (string-append "unfold hypotheses. cbv beta.\n"
                                 "  apply and_later. { first [at_numbers | polynomial_derivative]. }"
                                 " intro given_0.\n")))

(define (without-hypothesis text k)
  (define lines (string-split (hypotheses-of text) "\n"))
  (define (comment? line) (regexp-match? #px"^\\s*\\(\\*" line))
  (define kept (without-place (filter (lambda (l) (not (comment? l))) lines) k))
  (define body
    (string-join (for/list ([l (in-list (if (null? kept) '("  True") kept))])
                   (string-trim l " /\\" #:left? #f))
                 " /\\\n"))
  (define (pattern p)
    (define names (without-place (regexp-match* #rx"given_[0-9]+" p) k))
    (case (length names)
      [(0) "given"]
      [(1) (car names)]
      [else (format "(~a)" (string-join names " & "))]))
  (car (string-split
        (with-patterns (regexp-replace hypotheses-part text
                                       (lambda (_ before middle after)
                                         (string-append before body after)))
                       pattern)
        "Theorem not_vacuous")))

(define (without-place xs k) (append (take xs (- k 1)) (drop xs k)))

;; ---------------------------------------------------------------------------
;; Changed definitions

;; Of certificates by Coq's derivatives, at most `most` of each: functions with one more term, so
;; that what is said of their derivatives, or of the quantity along motions, does not hold any more.
(define (neighbours-by-definitions claims most)
  (for*/list ([c (in-list claims)]
              [x (in-value (certificate-or-reason (asked-verdict c)))]
              #:when (and (certificate? x) (eqv? 2 (certificate-level x)))
              [names (in-value (in-some-order (functions-defined (certificate-text x))))]
              [name (in-list (take names (min most (length names))))])
    (neighbour (format "~a, another ~a" (asked-name c) name) (kind-of c "changed definition")
               (with-one-more-term (certificate-text x) name))))

(define (functions-defined text)
  (map cadr (regexp-match* #px"Definition (\\w+) \\([^()]*\\) : R :=" text #:match-select values)))

;; The first coordinate is added, or of a function of the time alone the time.
(define (with-one-more-term text name)
  (regexp-replace (pregexp (format "(Definition ~a \\(([^:]*) : R\\) : R := )" name)) text
                  (lambda (_ start arguments)
                    (define all (string-split arguments))
                    (format "~a~a + " start (if (null? (cdr all)) (car all) (cadr all))))))
