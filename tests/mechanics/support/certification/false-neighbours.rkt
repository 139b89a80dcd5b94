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
         "proved-claims.rkt")

(provide false-neighbours neighbours-by-hypotheses neighbours-by-definitions
         (struct-out neighbour))

;; name : string; text : of the file
(struct neighbour (name text) #:authentic)

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
    (neighbour (format "~a, changed ~a" (asked-name c) k) text)))

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

;; claims : those of which each hypothesis is needed, with Coq's total functions too: there
;; x^a x^b = x^(a + b) holds for negative x as well
(define (neighbours-by-hypotheses claims)
  (append*
   (for/list ([c (in-list claims)])
     (define text (certificate-text (certificate-or-reason (asked-verdict c))))
     (define name (asked-name c))
     (append
      (for/list ([k (in-range (count-hypotheses text))])
        (neighbour (format "~a, without hypothesis ~a" name (+ k 1)) (without-hypothesis text k)))
      (list (neighbour (format "~a, hypotheses that contradict each other" name)
                       (with-hypothesis text "1 < 0"))
            (neighbour (format "~a, an empty domain" name)
                       (with-hypothesis text "(forall x : R, 0 <= - 1 - x * x)")))))))

(define hypotheses-part #px"(Definition hypotheses[^=]*:=\n)(.*?)(\\.\n\n)")

(define (hypotheses-of text)
  (filter (lambda (line) (not (regexp-match? #px"^\\s*\\(\\*" line)))
          (string-split (caddr (regexp-match hypotheses-part text)) "\n")))

(define (count-hypotheses text)
  (define all (hypotheses-of text))
  (if (equal? all '("  True")) 0 (length all)))

(define (with-hypotheses text lines pattern)
  (define body (string-join (for/list ([l (in-list lines)]) (string-trim l " /\\" #:left? #f))
                            " /\\\n"))
  (regexp-replace
   #px"(\n  intro[^\n]*|unfold hypotheses[.] intros [^(.]*?)(\\(given_1[^)]*\\)|given_1|given)[.]"
   (regexp-replace hypotheses-part text
                   (lambda (_ before middle after) (string-append before body after)))
   (lambda (_ before old) (format "~a~a." before pattern))))

(define (without-hypothesis text k)
  (define lines (hypotheses-of text))
  (define given (for/list ([i (in-range 1 (+ 1 (length lines)))]) (format "given_~a" i)))
  (define (without xs) (append (take xs k) (drop xs (+ k 1))))
  (if (= 1 (length lines))
      (with-hypotheses text '("  True") "given")
      (with-hypotheses text (without lines) (pattern-of (without given)))))

(define (with-hypothesis text more)
  (define lines (if (= 0 (count-hypotheses text)) '() (hypotheses-of text)))
  (define given (for/list ([i (in-range 1 (+ 1 (length lines)))]) (format "given_~a" i)))
  (with-hypotheses text (cons (string-append "  " more) lines) (pattern-of (cons "given_0" given))))

(define (pattern-of names)
  (if (null? (cdr names)) (car names) (format "(~a)" (string-join names " & "))))

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
    (neighbour (format "~a, another ~a" (asked-name c) name)
               (with-one-more-term (certificate-text x) name))))

(define (functions-defined text)
  (map cadr (regexp-match* #px"Definition (\\w+) \\([^()]*\\) : R :=" text #:match-select values)))

;; The first coordinate is added, or of a function of the time alone the time.
(define (with-one-more-term text name)
  (regexp-replace (pregexp (format "(Definition ~a \\(([^:]*) : R\\) : R := )" name)) text
                  (lambda (_ start arguments)
                    (define all (string-split arguments))
                    (format "~a~a + " start (if (null? (cdr all)) (car all) (cadr all))))))
