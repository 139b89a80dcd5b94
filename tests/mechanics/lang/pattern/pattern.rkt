#lang racket/base
;; Structure patterns in the argument positions of define, lambda and let.

(require mechanics/lang/pattern/pattern
         "../../support/checks.rkt" "../../support/messages.rkt")

;; The message of the syntax error that expanding a quoted form gives.
(define-namespace-anchor here)
(define (syntax-message form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (message-of (expand form) exn:fail:syntax?)))

(define (expanded form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (syntax->datum (expand form))))

(define (occurrences name datum)
  (cond [(eq? datum name) 1]
        [(pair? datum) (+ (occurrences name (car datum)) (occurrences name (cdr datum)))]
        [else 0]))

;; With the bindings of this file.
(define (namespaced stx)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (namespace-syntax-introduce stx)))

;; ---------------------------------------------------------------------------
;; Variables bound

(test-case "a pattern binds the components of the argument"
  (define (f (up t q v)) (list t q v))
  (check-equal? (f (up 1 2 3)) '(1 2 3)))

(test-case "patterns nest to any depth and mix orientations"
  (define (f (up t (up x (down y (up z))) (down p q))) (list t x y z p q))
  (check-equal? (f (up 1 (up 2 (down 3 (up 4))) (down 5 6))) '(1 2 3 4 5 6)))

(test-case "a curried head takes patterns at every level"
  (define ((L-central m U) (up t (up x y) (up vx vy))) (list m U t x y vx vy))
  (define (((f (up a)) (down b)) c) (list a b c))
  (check-equal? ((L-central 'm 'U) (up 0 (up 1 2) (up 3 4))) '(m U 0 1 2 3 4))
  (check-equal? (((f (up 1)) (down 2)) 3) '(1 2 3)))

(test-case "a Racket vector matches up, at every level, and never down"
  (define (f (up t (up x y))) (list t x y))
  (define (g (down x)) x)
  (check-equal? (f #(1 #(2 3))) '(1 2 3))
  (check-equal? (f (vector 1 (up 2 3))) '(1 2 3))
  (check-equal? (f (impersonate-vector (vector 1 #(2 3))
                                       (lambda (v i x) x) (lambda (v i x) x)))
                '(1 2 3))
  (check-exn #rx"^g: the argument does not match the pattern [(]down x[)]" (lambda () (g #(1)))))

(test-case "an underscore leaves a component out, as often as wanted"
  (define (velocity (up _ _ v)) v)
  (check-equal? (velocity (up 1 2 3)) 3))

(test-case "an empty pattern matches an empty tuple"
  (define (f (up)) 'empty)
  (check-equal? (f (up)) 'empty)
  (check-exn #rx"^f: the argument does not match the pattern [(]up[)]" (lambda () (f (up 1)))))

(test-case "arguments are taken apart in their order, before a default that uses them"
  (define f
    (parameterize ([current-namespace (namespace-anchor->namespace here)])
      (eval '(let () (define (f (up a b) (up c d) [x (+ a c)]) (list a b c d x)) f))))
  (check-equal? (f (up 1 2) (up 3 4)) '(1 2 3 4 4))
  (check-exn #rx"pattern [(]up a b[)]" (lambda () (f 1 2))))

(test-case "(define (up a b) ...) defines a function"
  (define (up a b) (list 'mine a b))
  (check-equal? (up 1 2) '(mine 1 2)))

(test-case "up and down as plain argument names are names"
  (define (f up . down) (list up down))
  (define ((g up) down) (list up down))
  (check-equal? (f 1 2) '(1 (2)))
  (check-equal? ((g 1) 2) '(1 2))
  (check-equal? ((lambda up up) 1 2) '(1 2)))

(test-case "where up means something else, its lists are Racket's arguments"
  (define (f up)
    (define (g [up 3]) up)
    (g))
  (check-equal? (f 1) 3))

(test-case "optional, keyword and rest arguments go with patterns"
  (define (f (up a b) [c (+ a b)] #:at [(down p q) (down a c)] . rest)
    (list a b c p q rest))
  (check-equal? (f (up 1 2)) '(1 2 3 1 3 ()))
  (check-equal? (f (up 1 2) 5 #:at (down 7 8) 9 10) '(1 2 5 7 8 (9 10))))

(test-case "a required keyword argument may be a pattern"
  (define (f #:state (up t q)) (list t q))
  (check-equal? (f #:state (up 1 2)) '(1 2)))

(test-case "an optional argument may be a pattern with a default"
  (define (f [(up a b) (up 1 2)] [(up c) (up b)]) (list a b c))
  (check-equal? (f) '(1 2 2))
  (check-equal? (f (up 3 4)) '(3 4 4))
  (check-equal? (f (up 3 4) (up 5)) '(3 4 5)))

(test-case "bodies may define, also names of the pattern"
  (define (f (up a b))
    (define a 10)
    (define c (+ a b))
    c)
  (check-equal? (f (up 1 2)) 12))

(test-case "lambda, λ and case-lambda take patterns"
  (check-equal? ((lambda ((up a b) c) (list a b c)) (up 1 2) 3) '(1 2 3))
  (check-equal? ((λ ((down a)) a) (down 1)) 1)
  (define f (case-lambda [((up a b)) (list 'one a b)]
                         [(x (up a)) (list 'two x a)]
                         [(x y . z) (list 'many x y z)]))
  (check-equal? (f (up 1 2)) '(one 1 2))
  (check-equal? (f 1 (up 2)) '(two 1 2))
  (check-equal? (f 1 2 3) '(many 1 2 (3))))

(test-case "let binds patterns beside names, let* one after another"
  (define a 1)
  (check-equal? (let ([(up a b) (up 2 3)] [c a]) (list a b c)) '(2 3 1))
  (check-equal? (let* ([(up a b) (up 2 3)] [c a] [(down d) (down (+ b c))])
                  (define e d)
                  (list a b c e))
                '(2 3 2 5)))

(test-case "named let takes patterns and loops"
  (check-equal? (let loop ([(up a b) (up 0 1)] [n 10])
                  (if (zero? n) a (loop (up b (+ a b)) (- n 1))))
                55))

(test-case "a function with patterns is called in tail position"
  (define (count (up i n)) (if (= i n) 'done (count (up (+ i 1) n))))
  (check-equal? (count (up 0 1000000)) 'done))

(test-case "without patterns the forms are Racket's"
  (define (f a [b 2] #:c [c 3] . d) (list a b c d))
  (define x 5)
  (check-equal? (f 1) '(1 2 3 ()))
  (check-equal? (let loop ([i 0]) (if (< i 5) (loop (+ i 1)) i)) x)
  (check-equal? (let* ([a 1] [a (+ a 1)]) a) 2)
  (check-equal? ((case-lambda [(a) 1] [(a b) 2]) 0 0) 2))

;; ---------------------------------------------------------------------------
;; Names and arities

(test-case "functions bear the name they are defined by, curried ones too"
  (define (f (up a b)) a)
  (define ((L m) (up t q v)) t)
  (define ((G m) x) x)
  (define g (lambda ((up a)) a))
  (define h (case-lambda [((up a)) a]))
  (check-equal? (map object-name (list f L (L 1) G (G 1) g h)) '(f L L G G g h)))

(test-case "a pattern counts as one argument"
  (define (f (up a b) c [d 1]) a)
  (define ((L m k) (up t q v)) t)
  (check-equal? (procedure-arity f) '(2 3))
  (check-equal? (procedure-arity L) 2)
  (check-equal? (procedure-arity (L 1 2)) 1)
  (define (g #:k (up a) #:o [(up b) (up 1)]) a)
  (define-values (required allowed) (procedure-keywords g))
  (check-equal? (list required allowed) '((#:k) (#:k #:o))))

;; ---------------------------------------------------------------------------
;; Mismatches

(test-case "a tuple of another length is named, with the pattern and the function"
  (define ((L-harmonic m k) (up t q v)) t)
  (check-equal?
   (message-of ((L-harmonic 'm 'k) (up 't 'x)))
   (string-append "L-harmonic: the argument does not match the pattern (up t q v): expected an "
                  "up tuple of 3, given (up t x) (an up tuple of 2)")))

(test-case "a component that does not match is placed"
  (define ((L-central m U) (up t (up x y) (up vx vy))) t)
  (check-equal?
   (message-of ((L-central 'm 'U) (up 't (up 'x 'y) (up 'u 'v 'w))))
   (string-append
    "L-central: the argument does not match the pattern (up t (up x y) (up vx vy)): "
    "at component 2, expected an up tuple of 2, given (up u v w) (an up tuple of 3)\n"
    "  in: (up t (up x y) (up u v w))")))

(test-case "a component of a component is placed too, and orientation told"
  (define (f (up _ (down a (up b c)))) a)
  (check-equal?
   (message-of (f (up 1 (down 2 (down 3 4)))))
   (string-append
    "f: the argument does not match the pattern (up _ (down a (up b c))): "
    "at component 1 of component 1, "
    "expected an up tuple of 2, given (down 3 4) (a down tuple of 2)\n"
    "  in: (up 1 (down 2 (down 3 4)))")))

(test-case "one argument of several is counted, a keyword argument named"
  (define (f x (up a b) #:at [(down p) (down 1)]) a)
  (check-equal?
   (message-of (f 1 (down 1 2)))
   (string-append "f: argument 2 does not match the pattern (up a b): expected an up tuple of "
                  "2, given (down 1 2) (a down tuple of 2)"))
  (check-equal?
   (message-of (f 1 (up 1 2) #:at 3))
   (string-append "f: argument #:at does not match the pattern (down p): expected a down tuple "
                  "of 1, given 3 (a number)")))

(test-case "a list and a function get advice"
  (define (f (up a b)) a)
  (check-equal?
   (message-of (f '(1 2)))
   (string-append "f: the argument does not match the pattern (up a b): expected an up tuple of "
                  "2, given (1 2) (a list); a list is not a tuple; use (up 1 2)"))
  (check-equal?
   (message-of (f f))
   (string-append "f: the argument does not match the pattern (up a b): expected an up tuple "
                  "of 2, given f (a function); apply the function to its argument first, or "
                  "use compose")))

(test-case "forms without a name say which form they are"
  (check-equal?
   (message-of ((lambda ((up a)) a) 1))
   (string-append "lambda: the argument does not match the pattern (up a): expected an up tuple "
                  "of 1, given 1 (a number)"))
  (check-equal?
   (message-of (let ([(up a) 1]) a))
   (string-append "let: the value does not match the pattern (up a): expected an up tuple of 1, "
                  "given 1 (a number)"))
  (check-equal?
   (message-of (let* ([(up a) 1]) a))
   (string-append "let*: the value does not match the pattern (up a): expected an up tuple of "
                  "1, given 1 (a number)"))
  (check-equal?
   (message-of (let loop ([(up a) (up 1)] [i 0]) (loop 1 2)))
   (string-append "loop: argument 1 does not match the pattern (up a): expected an up tuple of "
                  "1, given 1 (a number)")))

(test-case "a long value is cut in the message"
  (define (f (up a b)) a)
  (define message (message-of (f (list->vector (for/list ([i 1000]) i)))))
  (check-regexp-match #rx"\\.\\.\\.9[0-9][0-9] more" message)
  (check-true (< (string-length message) 500)))

;; ---------------------------------------------------------------------------
;; Syntax errors

(test-case "a name bound twice is an error, inside patterns and across arguments"
  (check-regexp-match #rx"^lambda: duplicate argument name\n  at: a"
                      (syntax-message '(lambda ((up a a)) a)))
  (check-regexp-match #rx"^lambda: duplicate argument name\n  at: a"
                      (syntax-message '(lambda ((up a b) (down c (up a))) a)))
  (check-regexp-match #rx"^define: duplicate argument name\n  at: b"
                      (syntax-message '(define (f b (up a b)) a)))
  (check-regexp-match #rx"^lambda: duplicate argument name\n  at: r"
                      (syntax-message '(lambda ((up r) . r) r)))
  (check-regexp-match #rx"^let: duplicate identifier\n  at: a"
                      (syntax-message '(let ([(up a b) 1] [a 2]) a)))
  (check-equal? (syntax-message '(let* ([(up a b) 1] [a 2]) a)) "no error"))

(test-case "what is no identifier in a pattern is refused"
  (check-regexp-match
   #rx"expected an identifier or a pattern \\(up ...\\) or \\(down ...\\)\n  at: 3"
   (syntax-message '(lambda ((up a 3)) a)))
  (check-regexp-match #rx"expected an identifier or a pattern"
                      (syntax-message '(lambda ((up a (left b))) a)))
  (check-regexp-match #rx"an ellipsis is allowed in the patterns of `match` only"
                      (syntax-message '(lambda ((up a ...)) a)))
  (check-regexp-match #rx"a structure pattern is a proper list"
                      (syntax-message '(lambda ((up a . b)) a))))

(test-case "a pattern without its head is told what it lacks, wherever it stands"
  (define message "(t q v) is no argument; a structure pattern begins with up or down: (up t q v)")
  (define (says? form who)
    (define text (syntax-message form))
    (check-equal? (car (regexp-split #rx"\n" text)) (string-append who ": " message)))
  (says? '(define (L (t q v)) 1) "define")
  (says? '(define ((L m) (t q v)) 1) "define")
  (says? '(define ((L (t q v)) m) 1) "define")
  (says? '(define ((L m) #:k (t q v)) 1) "define")
  (says? '(lambda (a (t q v)) 1) "lambda")
  (says? '(λ ([a 1] (t q v)) 1) "λ"))

(test-case "an optional argument is no pattern without its head"
  (for ([form '((lambda ([a 1] [(up b c) 2]) a) (define ((f [a 1]) #:k [b 2] . c) a))])
    (check-equal? (syntax-message form) "no error")))

(test-case "a procedure without a body is refused under the name of the form"
  (check-regexp-match #rx"^define: no expressions for procedure body"
                      (syntax-message '(define (f (up a)))))
  (check-regexp-match #rx"^lambda: no expressions for procedure body"
                      (syntax-message '(lambda ((up a))))))

(test-case "Racket's own complaints name the form and show it as written"
  (check-regexp-match #rx"^case-lambda: bad syntax" (syntax-message '(case-lambda x)))
  (check-regexp-match #rx"^lambda: " (syntax-message '(lambda (a a) a)))
  (check-regexp-match #rx"in: \\(define \\(f 3\\) 4\\)" (syntax-message '(define (f 3) 4)))
  (check-regexp-match #rx"^let: bad syntax" (syntax-message '(let ([a]) a))))

;; ---------------------------------------------------------------------------
;; Expansion

(test-case "each pattern is checked once and each name is one vector reference"
  (define code (expanded '(lambda ((up t (up x y) (down p _))) (list t x y p))))
  (check-equal? (occurrences 'structure? code) 3)
  (check-equal? (occurrences 'unsafe-vector*-ref code) 6)
  (check-equal? (occurrences 'match code) 0))

(test-case "without patterns nothing is added"
  (check-equal? (expanded '(lambda (x) x)) '(#%expression (lambda (x) x)))
  (check-equal? (expanded '(define (f x) x)) '(define-values (f) (lambda (x) x))))

;; ---------------------------------------------------------------------------
;; Written as elsewhere

;; The first line of the message.
(define-check (check-says form sentence)
  (define message (syntax-message form))
  (unless (equal? (car (regexp-match #rx"^[^\n]*" message)) sentence)
    (with-check-info (['message message]) (fail-check))))

(test-case "a name being defined is not quoted"
  (for ([row `(((define 'm 5) "define: a name being defined is not quoted: (define m 5)")
               ((define 'm (+ 1 'x))
                "define: a name being defined is not quoted: (define m (+ 1 'x))")
               ((define (f 't) (* 2 't))
                "define: a name being defined is not quoted: (define (f t) (* 2 't))")
               ((define ('f t) 1) "define: a name being defined is not quoted: (define (f t) 1)")
               ((define ((f 'm k) (up t 'q v) [n 'n]) 1 2)
                ,(string-append "define: a name being defined is not quoted: "
                                "(define ((f m k) (up t q v) (n 'n)) ...)"))
               ((lambda ('t) 't) "lambda: a name being defined is not quoted: (lambda (t) ...)")
               ((lambda 't 't) "lambda: a name being defined is not quoted: (lambda t ...)")
               ((λ (a ['b 1] . rest) a)
                "λ: a name being defined is not quoted: (λ (a (b 1) . rest) ...)")
               ((case-lambda [(a) a] [(a 'b) a])
                "case-lambda: a name being defined is not quoted: (case-lambda (a b) ...)"))])
    (check-says (car row) (cadr row))))

(test-case "the default of an argument may be quoted, and what is defined may be a symbol"
  (define (f [t 't]) t)
  (define ((g #:m [m 'm]) (up t q)) (list m t q))
  (define s 'm)
  (check-equal? (list (f) ((g) (up 1 2)) s) '(t (m 1 2) m)))

(test-case "a definition has no sign ="
  (for ([row '(((define m = 5) "define: a definition is written (define m 5)")
               ((define f (t) = (+ t 1)) "define: a definition is written (define (f t) (+ t 1))")
               ((define (f t) = (+ t 1)) "define: a definition is written (define (f t) (+ t 1))")
               ((define ((f m) t) = 1 2)
                "define: a definition is written (define ((f m) t) ...)"))])
    (check-says (car row) (cadr row)))
  (define same =)
  (define (f) =)
  (check-eq? same (f)))

(test-case "the name of a function and its arguments are in one pair of parentheses"
  (define (read-in text)
    (define port (open-input-string text))
    (port-count-lines! port)
    (read-syntax 'text port))
  (define (said text) (syntax-message (namespaced (read-in text))))
  (check-regexp-match (regexp-quote "define: a definition is written (define (f t) (* 2 t))\n")
                      (said "(define f(t) (* 2 t))"))
  (check-regexp-match #rx"several expressions; a function is written [(]define [(]E f t[)]"
                      (said "(define E (f t) (* 2 t))")))

(test-case "a pattern among arguments has parentheses of its own"
  (define said "an argument that is a tuple has parentheses of its own: ")
  (for ([row '(((lambda (up t q v) (* q v)) "lambda: ~a(lambda ((up t q v)) ...)")
               ((λ (down a b) (down b a)) "λ: ~a(λ ((down a b)) ...)")
               ((define (L up t q v) (* v v)) "define: ~a(define (L (up t q v)) ...)")
               ((define ((L m) up t (up x y) v) x)
                "define: ~a(define ((L m) (up t (up x y) v)) ...)")
               ((define ((L up q v) m) q) "define: ~a(define (L (up q v)) ...)")
               ((case-lambda [(a) a] [(up t q) q]) "case-lambda: ~a(case-lambda ((up t q)) ...)"))])
    (check-says (car row) (format (cadr row) said))))

(test-case "an argument may be called up, if it is used"
  (define (climb up down) (list up down))
  (define f (lambda (up) 'one))
  (define (g up n) (map up (list n)))
  (check-equal? (list (climb 2 1) (f 1) (g - 3)) '((2 1) one (-3))))
