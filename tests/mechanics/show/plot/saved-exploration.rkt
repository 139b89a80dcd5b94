#lang racket/base
;; A saved exploration is a program that draws it again: it is run as `racket FILE` runs it, on a
;; machine without a screen, and what it draws is compared with what was explored.

(require mechanics
         mechanics/book
         mechanics/plot
         (only-in mechanics/show/explorer/exploration
                  make-exploration add-orbit! add-points! zoom! exploration->dots)
         (only-in mechanics/show/explorer/exploration-program names-missing write-exploration)
         (only-in mechanics/show/plot/frame frame-view)
         (only-in mechanics/show/plot/on-demand why-not)
         (only-in mechanics/show/explorer/orbit-worker start-worker ask-worker stop-worker)
         racket/file
         "../../support/checks.rkt"
         "../../support/display.rkt" (only-in "../../support/example-programs.rkt" loaded-from)
         "../../support/patience.rkt" "../../support/picture-programs.rkt" "../../support/skip.rkt")

(define-namespace-anchor here)

;; n further points of each orbit, as the window receives them.
(define (follow! e map orbits n)
  (define ended (make-semaphore))
  (define left (make-hasheq))
  (define (receive o xs ys count why)
    (add-points! e o xs ys count)
    (hash-update! left o (lambda (n) (- n count)) n)
    (when (or why (<= (hash-ref left o) 0)) (semaphore-post ended)))
  (define worker (start-worker map receive))
  (for ([o (in-list orbits)])
    (ask-worker worker o n)
    (check-not-false (sync/patience 60 ended)))
  (stop-worker worker))

(define (explored map n starts #:bounds [bounds '(0 6.29 0 6.29)])
  (define e (make-exploration map n bounds))
  (follow! e map (for/list ([p (in-list starts)]) (add-orbit! e (car p) (cdr p))) n)
  e)

;; Colour and place of its points, in their order.
(define (dots e)
  (define all '())
  (exploration->dots e (lambda (color x y) (set! all (cons (list color x y) all))))
  (reverse all))
(define (points e)
  (for/list ([d (in-list (dots e))]) (vector (cadr d) (caddr d))))

(define (section) (frame 0 6.29 0 6.29 #:title "kicks" #:width 300 #:height 200))

(define (save e source [missing '()])
  (call-with-output-file "saved.rkt" #:exists 'truncate
    (lambda (port)
      (write-exploration e (frame-view (section)) source "saved.png" port #:missing missing))))

(define (redrawn map)
  (define namespace (loaded-from here 'mechanics 'mechanics/book 'mechanics/plot))
  (define redraw
    (parameterize ([current-namespace namespace])
      (namespace-require 'racket/base)
      (dynamic-require (path->complete-path "saved.rkt") 'redraw)))
  (redraw map))

;; The frame has its points colour by colour, latest first or last: all of them, in some order.
(define (check-redrawn e map)
  (define again (redrawn map))
  (define (sorted points)
    (sort (for/list ([p points]) (vector->list p))
          (lambda (p q) (or (< (car p) (car q)) (and (= (car p) (car q)) (< (cadr p) (cadr q)))))))
  (check-true (equal? (sorted (frame-points again)) (sorted (points e)))
              (format "~a and ~a points" (length (frame-points again)) (length (points e)))))

(define T (standard-map 0.6))
(define starts '((1.0 . 1.0) (0.1 . 3.0000000000000004) (3.0 . 0.5)))

(test-case "the points that were explored, to the last digit"
  (in-a-folder
   (define e (explored T 500 starts))
   (save e #f)
   (check-equal? (length (points e)) 1503)
   (check-redrawn e T)))

(test-case "in the part of the plane that was shown last"
  (in-a-folder
   (define e (explored T 500 starts))
   (zoom! e '(1.0 2.5 0.5 2.5))
   (save e #f)
   (define inside
     (for/sum ([p (in-list (points e))])
       (if (and (<= 1.0 (vector-ref p 0) 2.5) (<= 0.5 (vector-ref p 1) 2.5)) 1 0)))
   (check-equal? (length (frame-points (redrawn T))) inside)
   (check-true (< 0 inside 1503))))

;; Where a click has no image, or the map fails on the way, there is nothing more to draw.
(test-case "orbits that end early, or never began, are redrawn as far as they went"
  (define (down x y return fail)
    (cond [(> y 5) (fail)] [(> y 0.5) (return x (- y 1))] [(< x 1) (fail)] [else (error "lost")]))
  (in-a-folder
   (define e (explored down 100 '((0.5 . 3.25) (2.0 . 3.25) (1.0 . 6.0) (2.0 . 0.25))))
   (save e #f)
   (check-equal? (length (points e)) 8)
   (check-redrawn e down)))

;; ---------------------------------------------------------------------------
;; Names that the program does not know

(define (missing source)
  (names-missing source (loaded-from here 'mechanics 'mechanics/book 'mechanics/plot)))

(test-case "names of the map's expression that the program does not know"
  (check-equal? (missing '(standard-map 0.6)) '())
  (check-equal? (missing #f) '())
  (check-equal? (missing '(lambda (x y return fail) (return (+ x (* my-K y)) y))) '(my-K))
  (check-regexp-match #rx"^if: bad syntax" (missing '(if))))

;; ---------------------------------------------------------------------------
;; As a program

;; The output of the program, where no screen is.
(define (run-saved)
  (run-program (path->complete-path "saved.rkt") (environment-with #"nowhere:99")))

(skip-unless (not (why-not))
             "the shared libraries of racket/draw are not installed: no pictures"
  (test-case "run by itself it writes the picture of what was explored"
    (in-a-folder
     (define e (explored T 500 starts))
     (save e '(standard-map 0.6))
     (check-equal? (run-saved) "")
     (define f (section))
     (for ([d (in-list (dots e))])
       (plot-point f (cadr d) (caddr d) #:color (car d)))
     (graphics-save f "expected.png")
     (check-equal? (file->bytes "saved.png") (file->bytes "expected.png"))))

  (test-case "where it does not know a name it says so, runs, and with a definition draws"
    (in-a-folder
     (define unknown (missing '(my-map (* 2 K))))
     (check-equal? unknown '(K my-map))
     (save (explored T 5 starts) '(my-map (* 2 K)) unknown)
     (check-equal? (run-saved) "")
     (check-false (file-exists? "saved.png"))
     (define text (file->string "saved.rkt"))
     (check-regexp-match #rx"known; with them this draws it: K my-map\n#;\n[(]module[+] main" text)
     (define completed
       (regexp-replace "#;\n" text "(define K 0.3)\n(define my-map standard-map)\n"))
     (display-to-file completed "saved.rkt" #:exists 'truncate)
     (check-equal? (run-saved) "")
     (check-true (file-exists? "saved.png"))))

  (test-case "without the expression of the map it tells how it is drawn"
    (in-a-folder
     (save (explored T 5 starts) #f)
     (check-equal? (run-saved) "")
     (check-false (file-exists? "saved.png"))
     (check-regexp-match #rx";; [(]graphics-save [(]redraw map[)] \"saved.png\"[)] draws it"
                         (file->string "saved.rkt")))))
