#lang racket/base
;; The layout of expressions: what fits stays on a line, what does not is
;; broken where it reads best, and nothing is lost but what the bound cuts.

(require mechanics/algebra/expression/write
         mechanics/show/display/layout
         racket/list
         racket/string
         "../../support/checks.rkt")

(define (lines . ls) (string-join ls "\n"))

(test-case "what fits is written on one line, symbols bare"
  (check-equal? (layout 'a 20) "a")
  (check-equal? (layout 1/2 20) "1/2")
  (check-equal? (layout '() 20) "()")
  (check-equal? (layout '(f) 20) "(f)")
  (check-equal? (layout '(+ (* 2 a) (((expt D 2) x) t)) 79) "(+ (* 2 a) (((expt D 2) x) t))"))

(test-case "a line may be exactly as long as the width, closing parentheses included"
  (define d '(force (gravity alpha beta)))
  (check-equal? (layout d 28) "(force (gravity alpha beta))")
  (check-equal? (layout d 27) (lines "(force (gravity alpha"
                                     "                beta))")))

(test-case "sums, quotients and tuples get a line for each component"
  (check-equal? (layout '(up (+ a b) (/ (* c d) (* e f))) 20)
                (lines "(up (+ a b)"
                       "    (/ (* c d)"
                       "       (* e f)))")))

(test-case "products and applications fill their lines"
  (check-equal? (layout '(* 1/2 m (expt l 2) (cos theta) (sin theta) g) 24)
                (lines "(* 1/2 m (expt l 2)"
                       "   (cos theta)"
                       "   (sin theta) g)")))

(test-case "a tuple of atoms fills its lines"
  (check-equal? (layout (cons 'up (range 20)) 24)
                (lines "(up 0 1 2 3 4 5 6 7 8 9"
                       "    10 11 12 13 14 15 16"
                       "    17 18 19)")))

(test-case "operands stand below a long head"
  (check-equal? (layout '(((partial 1) a-long-name) (up t (up x y) (up u v))) 32)
                (lines "(((partial 1) a-long-name)"
                       " (up t (up x y) (up u v)))")))

(test-case "an item that needs several lines has them alone"
  (check-equal? (layout '(* m (+ (* a b c) (* d e f)) n) 18)
                (lines "(* m"
                       "   (+ (* a b c)"
                       "      (* d e f))"
                       "   n)")))

(test-case "no line is longer than the width, as long as nesting leaves room"
  (define (random-datum depth)
    (if (or (zero? depth) (< (random) 0.2))
        (list-ref '(a bb theta 1/2 -3) (random 5))
        (cons (list-ref '(+ * up down F expt) (random 6))
              (for/list ([i (+ 1 (random 4))]) (random-datum (sub1 depth))))))
  (define seed 20240611)
  (random-seed seed)
  (for ([i 200])
    (define d (random-datum 6))
    (define text (layout d 79))
    (check-equal? (read (open-input-string text)) d (format "seed ~a, case ~a" seed i))
    (for ([line (string-split text "\n")])
      (check-true (<= (string-length line) 79)
                  (format "seed ~a, case ~a: ~a" seed i line)))))

(test-case "after print-limit atoms the rest is counted, not written"
  (parameterize ([print-limit 4])
    (check-equal? (layout '(up a b c d e) 79) "(up a b c ...2 more)")
    (check-equal? (layout '(+ (* a b c d) e) 79) "(+ (* a b ...2 more) ...1 more)"))
  (parameterize ([print-limit #f])
    (check-equal? (string-length (layout (cons 'up (make-list 5000 'x)) 20000))
                  (+ 2 (string-length "up") 10000))))

(test-case "the bound is that of datum->text"
  (define d '(up (+ a (* b c)) (* d e f g) (expt h 2) i j))
  (for ([limit (in-range 1 16)])
    (parameterize ([print-limit limit])
      (check-equal? (layout d 1000) (datum->text d)))))

(test-case "structure shared and nested 200 deep is written within bounds"
  (define shared (for/fold ([d 'x]) ([i 200]) (list '+ d d)))
  (check-true (< (string-length (layout shared 79)) 20000)))

(test-case "a head of 16 letters has its operands beside it, a longer one below"
  (define (broken n) (layout (list (string->symbol (make-string n #\f)) '(a b c d) '(e f g h)) 28))
  (check-equal? (broken 16) (lines "(ffffffffffffffff (a b c d)" "                  (e f g h))"))
  (check-equal? (broken 17) (lines "(fffffffffffffffff" " (a b c d) (e f g h))")))
