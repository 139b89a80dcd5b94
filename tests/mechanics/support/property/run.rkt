#lang racket/base
;; Runs of the properties: a seed makes an expression, rewrites of it, and a
;; wrong variant; failures are shrunk and told with their seed.
;;
;;     racket tests/mechanics/support/property/run.rkt --count 20000 --seed 1
;;
;; makes a long one, tells every failure with the least expression that fails,
;; and counts them by kind.  `--only N` runs the seed N alone; with `--quick`
;; nothing is shrunk; what takes more than `--limit` seconds of a processor is told as hanging.

(require racket/cmdline
         racket/list
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         "../patience.rkt"
         "expressions.rkt" "places.rkt" "property.rkt" "rules.rkt" "shrink.rkt" "value.rkt")

(provide run-seed (struct-out failure) failure->string)

;; property : a name; rule : of the rewrite, or #f; minimal : the least expression
;; that fails
(struct failure (seed class property rule expression minimal text) #:transparent)

(define (failure->string f)
  (format "seed ~a, ~a: ~a~a\n  of ~s\n  least ~s\n  ~a"
          (failure-seed f) (failure-class f) (failure-property f)
          (if (failure-rule f) (format " by ~a" (failure-rule f)) "")
          (expression->datum (failure-expression f))
          (expression->datum (failure-minimal f))
          (failure-text f)))

;; ---------------------------------------------------------------------------

;; -> failures
(define (run-seed seed #:shrink? [shrink? #t])
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed (modulo (* 48271 (+ seed 7)) 2147483647))
    (define class (list-ref classes (modulo seed (length classes))))
    (define e (random-expression (class-depth class) (class-kinds class)))
    (define (failed property rule e text again)
      (define minimal (if shrink? (shrink e (guarded again)) e))
      (failure seed class property rule e minimal
               (if shrink? ((guarded again) minimal) text)))
    (filter values
            (append
             (for/list ([p (in-list single-properties)])
               (define text ((guarded (cdr p)) e))
               (and text (failed (car p) #f e text (cdr p))))
             (rewriting-failures e class failed)
             (list (variant-failure e failed))))))

(define single-properties
  (list (cons 'value-kept value-kept) (cons 'idempotent idempotent)))

(define pair-properties
  (list (cons 'same-by-form same-by-form)
        (cons 'same-by-print same-by-print)
        (cons 'same-by-fingerprint same-by-fingerprint)
        (cons 'same-by-verdict same-by-verdict)))

;; An exception of a property is a failure too, but for a division by zero.
(define ((guarded property) . es)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)]
                  [exn:fail? (lambda (x) (format "raised ~a" (exn-message x)))])
    (apply property es)))

;; ---------------------------------------------------------------------------
;; Rewrites

(define (fits? r e p)
  (define part (at-place e p))
  (and (not (tuple? part))
       (or (not (eq? (rule-kind r) 'outside)) (arithmetic-above? e p))
       (part-rewritten r part)))

;; Is all that stands above the place arithmetic?
(define (arithmetic-above? e p)
  (or (null? p)
      (and (memq (node-head e) (list op:+ op:- op:* op:/))
           (arithmetic-above? (list-ref (node-args e) (car p)) (cdr p)))))

(define (tuple? e) (and (node? e) (memq (node-head e) (list op:up op:down)) #t))

(define (part-rewritten r part) ((rule-procedure r) part))

(define (rewritten e r p) (replace-at e p (part-rewritten r (at-place e p))))

;; A rule that fits somewhere, and a place; or #f #f.
(define (random-rewrite e allowed)
  (define all (scalar-places e))
  (define candidates (shuffle allowed))
  (define r (for/first ([r (in-list candidates)]
                        #:when (for/or ([p (in-list all)]) (fits? r e p)))
              r))
  (if r
      (values r (list-ref-random (filter (lambda (p) (fits? r e p)) all)))
      (values #f #f)))

(define (list-ref-random xs) (list-ref xs (random (length xs))))

;; Places where an expression may stand: not an exponent, nor within a tuple.
(define (scalar-places e)
  (for/list ([p (in-list (places e))] #:unless (within-exponent? e p)) p))

(define (within-exponent? e p)
  (let loop ([e e] [p p])
    (cond [(null? p) #f]
          [(and (eq? (node-head e) op:expt) (eqv? (car p) 1) (number? (cadr (node-args e)))) #t]
          [else (loop (list-ref (node-args e) (car p)) (cdr p))])))

;; Several rewrites one after the other, each compared with what was there first.
;; The first step that fails by itself is the one to blame.
(define (rewriting-failures e class failed)
  (define nested? (memq 'nested (class-kinds class)))
  (define steps (+ 1 (random 3)))
  (if nested?
      '()
      (let loop ([k 0] [current e] [chain '()])
        (if (= k steps)
            '()
            (let-values ([(r p) (random-rewrite current rules)])
              (define next (and r (rewritten current r p)))
              (define found (if next (step-failures e current next r p failed) '()))
              (if (pair? found)
                  found
                  (loop (+ k 1) (or next current) (cons r chain))))))))

(define (step-failures e current next r p failed)
  (if (alike? r current next) (blame e current next r p failed) '()))

;; Do rewrites agree where all symbols are positive?  Where nothing is real, as with
;; log -1, or operands of roots are negative, rules promise nothing.  r : the rule,
;; #f for several
(define (alike? r u v)
  (for/or ([point (in-list '(1 3 5 7))])
    (define x (value-at-point u point))
    (define y (value-at-point v point))
    (and x y
         (or (agree? x y)
             (and r (not (eq? (rule-kind r) 'positive))
                  (error 'rule "~a is unsound: ~a, ~a" (rule-name r) u v))))))

(define (blame e current next r p failed)
  (for*/first ([property (in-list pair-properties)]
               #:unless (and (eq? (car property) 'same-by-print)
                             (not (eq? (rule-kind r) 'always)))
               [text (in-value (pair-failure property e current next))]
               #:when text)
    (list
     (failed (car property) (rule-name r) current text
             (lambda (smaller)
               (for/or ([q (in-list (scalar-places smaller))] [_ (in-range 40)]
                        #:when (fits? r smaller q)
                        #:when (alike? r smaller (rewritten smaller r q)))
                 (pair-failure property smaller smaller (rewritten smaller r q))))))))

(define (pair-failure property e current next)
  (or ((guarded (cdr property)) current next)
      (and (not (eq? e current))
           (alike? #f e next)
           (not (eq? (car property) 'same-by-print))
           ((guarded (cdr property)) e next))))

;; ---------------------------------------------------------------------------
;; Wrong variants

(define (variant-failure e failed)
  (define p (list-ref-random (scalar-places e)))
  (define part (at-place e p))
  (define change (random 6))
  (define other (and (not (tuple? part)) (changed part change)))
  (define (told-apart-somewhere e)
    (for/or ([q (in-list (scalar-places e))])
      (define part (at-place e q))
      (and (not (tuple? part))
           (told-apart e (replace-at e q (changed part change))))))
  (and other
       (let ([text ((guarded told-apart) e (replace-at e p other))])
         (and text (failed 'told-apart #f e text told-apart-somewhere)))))

(define (changed e how)
  (case how
    [(0) (make-node op:* (list -1 e))]
    [(1) (make-node op:* (list 2 e))]
    [(2) (make-node op:+ (list e 1/3))]
    [(3) (if (eq? e 'a) 'b 'a)]
    [(4) (make-node op:expt (list e 2))]
    [else (make-node op:+ (list e (make-node op:* (list 1/1000 (make-node op:sin '(b))))))]))

;; ---------------------------------------------------------------------------
;; Long runs

(module+ main
  (define count 1000)
  (define start 1)
  (define shrink? #t)
  (define limit 20)
  (define (integer text) (or (string->number text) (raise-user-error 'run "not a number: ~a" text)))
  (command-line
   #:once-each
   [("--count") n "how many expressions" (set! count (integer n))]
   [("--seed") s "the first seed" (set! start (integer s))]
   [("--only") s "one seed alone" (set! start (integer s)) (set! count 1)]
   [("--limit") s "seconds for one expression" (set! limit (integer s))]
   [("--quick") "shrink nothing" (set! shrink? #f)])
  (define tally (make-hash))
  (define (note! key) (hash-update! tally key add1 0))
  (for ([seed (in-range start (+ start count))])
    (for ([f (in-list (within limit seed shrink?))])
      (cond [(failure? f)
             (note! (failure-property f))
             (printf "~a\n\n" (failure->string f))]
            [else
             (note! f)
             (printf "seed ~a: ~a\n\n" seed f)])
      (flush-output)))
  (printf "~a expressions; ~a\n" count
          (if (zero? (hash-count tally)) "no failure" (hash->list tally))))

;; The failures of a seed, or (hanging).
(define (within limit seed shrink?)
  (value-within limit 2000 (lambda () (run-seed seed #:shrink? shrink?)) '(hanging)))
