#lang racket/base
;; Quaternions and power series of random coefficients, and tuples of them, are read back from
;; one line.  Not so endless series, and sums of terms that are kept apart: a line has not all
;; terms of the one, and looks like a mere sum for the other.
;;
;; `racket tests/mechanics/show/display/read-back.rkt 10000` is a long run.

(require mechanics
         (only-in "../../support/property/expressions.rkt" choose)
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/read-back.rkt")

;; ---------------------------------------------------------------------------

(define (random-value depth)
  (define (coefficient) (choose 0 0 1 -1 (random-formula (choose 0 1 2))))
  (case (if (> depth 0) (random 3) (random 2))
    [(0) (apply quaternion (for/list ([_ 4]) (coefficient)))]
    [(1) (apply power-series (for/list ([_ (choose 1 2 4 7)]) (coefficient)))]
    [else (apply (choose up down) (for/list ([_ (random 1 4)]) (random-value (- depth 1))))]))

;; -> how many coefficients had values to compare
(define (check-same-values v w seed)
  (define (each part count)
    (for/sum ([k (in-range count)]) (check-same-values (part v k) (part w k) (+ seed k))))
  (cond [(quaternion? v)
         (check-true (quaternion? w))
         (each quaternion-ref 4)]
        [(power-series? v)
         (check-true (power-series? w))
         (each series:ref 8)]
        [(or (up? v) (down? v))
         (check-eq? (up? v) (up? w))
         (each ref (s:length v))]
        [else (check-same-value v w seed)]))

(define (check-same-value v w seed)
  (define-values (x y) (values (value-of v seed) (value-of w seed)))
  (cond [(and x y)
         (check-true (close? x y) (format "~a and ~a" x y))
         1]
        [else 0]))

(define (check-random count seed)
  (random-seed seed)
  (for/sum ([k (in-range count)])
    (define v (random-value 2))
    (define text (->infix v))
    (with-check-info (['value v] ['text text] ['seed seed])
      (define w (read-infix text))
      (check-equal? (->infix (read-infix (->infix w))) (->infix w))
      (check-same-values v w k))))

(test-case "random quaternions and power series are read back"
  (check-true (> (check-random 200 20250102) 500)))

(test-case "a reader that took a coefficient for another would be noticed"
  (check-exn exn:test:check?
             (lambda ()
               (parameterize ([current-check-handler raise])
                 (check-same-values (power-series 0 'a) (power-series 'a 0) 1)))))

(test-case "a quaternion without its three parts is none the less a quaternion"
  (check-equal? (->infix (quaternion 3 0 0 0)) "3 + 0 𝐢")
  (check-equal? (read-infix "3 + 0 𝐢") (quaternion 3 0 0 0))
  (check-equal? (->infix (quaternion 0 0 0 0)) "0 𝐢"))

(test-case "the variable of a power series is no name in it"
  (define s (apply power-series '(x z s u w y xi x_1 1)))
  (check-equal? (substring (->infix s) 0 2) "x₂")
  (check-equal? (read-infix (->infix s)) s))

(says
 [(read-infix (->infix (series:generate (lambda (k) 'a))))
  "read-infix: not a formula on one line\n  at: ⋯, which stands for terms that are not written, position 16\n  in: a + a + a + a + ⋯"]
 [(read-infix "x ↦ sin x")
  "read-infix: not a formula on one line\n  at: no power series, position 2\n  in: x ↦ sin x"])

(module+ main
  (require racket/cmdline)
  (command-line
   #:args ([count "10000"])
   (printf "~a coefficients compared\n"
           (check-random (string->number count) (random 1000000)))))
